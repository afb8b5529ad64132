package org.starl;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.TreeSet;

/** A set of robots in the order of their names. Immutable. */
public final class Participants implements Iterable<RobotId> {

  private final List<RobotId> ids;

  private Participants(Collection<RobotId> ids) {
    this.ids = List.copyOf(new ArrayList<>(new TreeSet<>(ids)));
  }

  public static Participants of(RobotId... ids) {
    return new Participants(List.of(ids));
  }

  public static Participants of(Collection<RobotId> ids) {
    return new Participants(ids);
  }

  public boolean contains(RobotId id) {
    return ids.contains(id);
  }

  public int size() {
    return ids.size();
  }

  /** The robots in order. */
  public List<RobotId> asList() {
    return ids;
  }

  @Override
  public Iterator<RobotId> iterator() {
    return ids.iterator();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Participants that && ids.equals(that.ids);
  }

  @Override
  public int hashCode() {
    return ids.hashCode();
  }

  @Override
  public String toString() {
    return ids.toString();
  }
}

package org.starl;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** A set of robots in the order of their names. Immutable. */
public final class Participants implements Iterable<RobotId> {

  private final List<RobotId> ids;

  // Made when first asked for: most sets are never asked. Two threads may both make it, and get
  // equal ones: it is immutable.
  private @Nullable Names names;

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

  /** The robot whose name in ASCII these bytes are, or null if it is none of these. */
  public @Nullable RobotId find(byte[] bytes, int from, int length) {
    Names found = names;
    if (found == null) {
      found = new Names(ids);
      names = found;
    }
    return found.find(bytes, from, length);
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

  /** A hash table with open addressing, at most half full. */
  private static final class Names {
    private static final int GOLDEN_RATIO = 0x9E3779B9;

    private final @Nullable RobotId[] slots;

    Names(List<RobotId> ids) {
      slots = new RobotId[Integer.highestOneBit(2 * ids.size() + 1) * 2];
      for (RobotId id : ids) {
        int slot = slot(id.name().hashCode());
        while (slots[slot] != null) {
          slot = (slot + 1) & (slots.length - 1);
        }
        slots[slot] = id;
      }
    }

    @Nullable RobotId find(byte[] bytes, int from, int length) {
      int hash = 0;
      for (int i = from; i < from + length; i++) {
        hash = 31 * hash + bytes[i]; // as String.hashCode does
      }
      int slot = slot(hash);
      RobotId id = slots[slot];
      while (id != null && !id.isNamed(bytes, from, length)) {
        slot = (slot + 1) & (slots.length - 1);
        id = slots[slot];
      }
      return id;
    }

    /**
     * Fibonacci hashing (Knuth, "The Art of Computer Programming", section 6.4): names that differ in
     * their last digits have neighbouring hashes, which would fill long runs of slots.
     */
    private int slot(int hash) {
      return (hash * GOLDEN_RATIO) >>> (Integer.numberOfLeadingZeros(slots.length) + 1);
    }
  }
}

package org.starl.id;

import java.util.BitSet;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * A set of robots that changes. Each robot of a deployment takes one bit, so that a thousand robots
 * may each keep thousands of sets of all robots. Other robots can be in it, too.
 */
public final class RobotSet {

  private final Participants deployment;

  /** By the robots' places in the deployment. */
  private final BitSet members = new BitSet();

  private final SortedSet<RobotId> others = new TreeSet<>();

  /** The empty set. */
  public RobotSet(Participants deployment) {
    this.deployment = deployment;
  }

  public boolean contains(RobotId robot) {
    int place = deployment.indexOf(robot);
    return place < 0 ? others.contains(robot) : members.get(place);
  }

  /** Returns whether it was not in the set. */
  public boolean add(RobotId robot) {
    int place = deployment.indexOf(robot);
    if (place < 0) {
      return others.add(robot);
    }
    boolean isNew = !members.get(place);
    members.set(place);
    return isNew;
  }

  /**
   * Adds all of a set.
   *
   * @param more of the same deployment
   */
  public void addAll(RobotSet more) {
    if (!deployment.equals(more.deployment)) {
      throw new IllegalArgumentException(
          "a set in " + more.deployment + ": expected one in " + deployment);
    }
    members.or(more.members);
    others.addAll(more.others);
  }

  /** Returns whether it was in the set. */
  public boolean remove(RobotId robot) {
    int place = deployment.indexOf(robot);
    if (place < 0) {
      return others.remove(robot);
    }
    boolean wasIn = members.get(place);
    members.clear(place);
    return wasIn;
  }

  public void clear() {
    members.clear();
    others.clear();
  }

  /** The robots in it now, sorted. */
  public SortedSet<RobotId> sorted() {
    SortedSet<RobotId> all = new TreeSet<>(others);
    members.stream().forEach(place -> all.add(deployment.asList().get(place)));
    return all;
  }

  /** The robots of the deployment that are not in it now, sorted. */
  public SortedSet<RobotId> missing() {
    SortedSet<RobotId> missing = new TreeSet<>();
    for (int place = members.nextClearBit(0);
        place < deployment.size();
        place = members.nextClearBit(place + 1)) {
      missing.add(deployment.asList().get(place));
    }
    return missing;
  }

  /** {@code [bot1, bot2]}. */
  @Override
  public String toString() {
    return sorted().toString();
  }
}

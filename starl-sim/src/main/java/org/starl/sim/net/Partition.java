package org.starl.sim.net;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.starl.id.RobotId;

/**
 * A network partition. Datagrams pass within a group, and among the robots in no group. A one-way
 * partition blocks only datagrams from one group to the other. Install it to split, uninstall it to
 * heal.
 */
public final class Partition implements LinkRule {

  private static final Verdict CUT = Verdict.drop("partition");
  private static final int NO_GROUP = -1;

  private final List<Set<RobotId>> groups = new ArrayList<>();
  private final boolean oneWay;

  private Partition(List<? extends Collection<RobotId>> groups, boolean oneWay) {
    this.oneWay = oneWay;
    for (Collection<RobotId> group : groups) {
      this.groups.add(new HashSet<>(group));
    }
  }

  /**
   * The given groups; all other robots form one more group. A robot in two groups belongs to the
   * first.
   */
  public static Partition of(List<? extends Collection<RobotId>> groups) {
    return new Partition(groups, false);
  }

  /** These robots on one side, all others on the other. */
  public static Partition isolating(RobotId... robots) {
    return new Partition(List.of(List.of(robots)), false);
  }

  /** One way: datagrams from {@code from} do not reach {@code to}. */
  public static Partition oneWay(Collection<RobotId> from, Collection<RobotId> to) {
    return new Partition(List.of(from, to), true);
  }

  @Override
  public Verdict judge(Transmission copy) {
    boolean isCut =
        oneWay
            ? groups.get(0).contains(copy.from()) && groups.get(1).contains(copy.to())
            : groupOf(copy.from()) != groupOf(copy.to());
    return isCut ? CUT : Verdict.PASS;
  }

  private int groupOf(RobotId robot) {
    for (int i = 0; i < groups.size(); i++) {
      if (groups.get(i).contains(robot)) {
        return i;
      }
    }
    return NO_GROUP;
  }
}

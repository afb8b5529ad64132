package org.starl.robot.udp;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * Each robot's newest beacon, and the robots that are suspected because they have been silent for too
 * long. Silence proves nothing: a suspected robot may be driving. Pure; one thread.
 */
final class Neighbours {

  /** The result of a genuine beacon. */
  enum Verdict {
    /** The first one, or the first one after a silence. */
    APPEARED,
    HEARD,
    /** Older than one that was heard: recorded and sent again, or overtaken. */
    OLD,
    /** From a robot that the deployment does not have, or from this robot. */
    STRANGE
  }

  private final RobotId self;
  private final Participants deployment;
  private final long suspectAfterNs;
  private final SortedMap<RobotId, Neighbour> heard = new TreeMap<>();
  private final long beganNs;

  private static final class Neighbour {
    private long start = Long.MIN_VALUE;
    private long count;
    private long lastNs;
    private boolean isPresent;
    private boolean isSuspected;
  }

  Neighbours(RobotId self, Participants deployment, long suspectAfterNs, long nowNs) {
    this.self = self;
    this.deployment = deployment;
    this.suspectAfterNs = suspectAfterNs;
    this.beganNs = nowNs;
  }

  /** Takes a genuine beacon that arrived at {@code nowNs}. */
  Verdict hear(Beacon beacon, long nowNs) {
    if (beacon.robot().equals(self) || !deployment.contains(beacon.robot())) {
      return Verdict.STRANGE;
    }
    Neighbour neighbour = heard.computeIfAbsent(beacon.robot(), id -> new Neighbour());
    boolean isNewer =
        beacon.start() > neighbour.start
            || (beacon.start() == neighbour.start && beacon.count() > neighbour.count);
    if (!isNewer) {
      return Verdict.OLD;
    }
    neighbour.start = beacon.start();
    neighbour.count = beacon.count();
    neighbour.lastNs = nowNs;
    boolean wasPresent = neighbour.isPresent;
    neighbour.isPresent = true;
    neighbour.isSuspected = false;
    return wasPresent ? Verdict.HEARD : Verdict.APPEARED;
  }

  /** The robots suspected since the last call, in order; robots that were never heard are included. */
  List<RobotId> newlySuspected(long nowNs) {
    List<RobotId> suspected = new ArrayList<>();
    for (RobotId robot : deployment.asList()) {
      if (robot.equals(self)) {
        continue;
      }
      Neighbour neighbour = heard.computeIfAbsent(robot, id -> new Neighbour());
      long sinceNs = neighbour.start == Long.MIN_VALUE ? beganNs : neighbour.lastNs;
      if (!neighbour.isSuspected && nowNs - sinceNs > suspectAfterNs) {
        neighbour.isSuspected = true;
        neighbour.isPresent = false;
        suspected.add(robot);
      }
    }
    return suspected;
  }

  /** The time of a robot's last beacon; null if it was never heard. */
  @Nullable Long lastHeardNs(RobotId robot) {
    Neighbour neighbour = heard.get(robot);
    return neighbour == null || neighbour.start == Long.MIN_VALUE ? null : neighbour.lastNs;
  }
}

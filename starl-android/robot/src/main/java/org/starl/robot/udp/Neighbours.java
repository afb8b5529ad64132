package org.starl.robot.udp;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;

/**
 * Who was heard when: each robot's newest beacon, and who has been silent for so long that something
 * must be wrong with it. Silence proves nothing: a robot that is suspected may drive. Pure; one thread.
 */
final class Neighbours {

  /** What becomes of a beacon that is genuine. */
  enum Verdict {
    /** The first one, or the first one after a silence: its robot is here. */
    APPEARED,
    HEARD,
    /** Older than one that was heard: it was recorded, or overtaken. */
    OLD,
    /** Of a robot that the deployment does not know, or of this one. */
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
    private boolean isHere;
    private boolean isSuspected;
  }

  Neighbours(RobotId self, Participants deployment, long suspectAfterNs, long nowNs) {
    this.self = self;
    this.deployment = deployment;
    this.suspectAfterNs = suspectAfterNs;
    this.beganNs = nowNs;
  }

  /** Takes in a genuine beacon that came at {@code nowNs}. */
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
    boolean wasHere = neighbour.isHere;
    neighbour.isHere = true;
    neighbour.isSuspected = false;
    return wasHere ? Verdict.HEARD : Verdict.APPEARED;
  }

  /** Those who are to be suspected since the last call, in order; who was never heard is as well. */
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
        neighbour.isHere = false;
        suspected.add(robot);
      }
    }
    return suspected;
  }

  /** When a robot was heard last; null if it never was. */
  @Nullable Long lastHeardNs(RobotId robot) {
    Neighbour neighbour = heard.get(robot);
    return neighbour == null || neighbour.start == Long.MIN_VALUE ? null : neighbour.lastNs;
  }
}

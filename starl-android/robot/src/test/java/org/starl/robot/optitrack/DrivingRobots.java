package org.starl.robot.optitrack;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Pose;
import org.starl.platform.Clock;
import org.starl.robot.contract.PositioningContract.Course;
import org.starl.robot.realtime.RealClock;

/** Two robots that drive along x by one clock, as cameras with another clock see them. */
final class DrivingRobots implements PoseSource {

  /** Long before any other clock here began. */
  final Clock cameraClock = new RealClock(RealClock.machineNs() - 1_234_567_890_123L);

  private final Clock clock;
  private volatile boolean isFirstSeen = true;
  private volatile boolean isSecondSeen = true;

  DrivingRobots(Clock clock) {
    this.clock = clock;
  }

  void see(int robot, boolean isSeen) {
    if (robot == 0) {
      isFirstSeen = isSeen;
    } else {
      isSecondSeen = isSeen;
    }
  }

  @Override
  public Snapshot snapshot() {
    double xMm = Course.xMm(clock.nowNs());
    long atNs = cameraClock.nowNs();
    List<Body> bodies = new ArrayList<>();
    bodies.add(new Body("robot0", new Pose(xMm, 0, 0), isFirstSeen, 0.3));
    bodies.add(new Body("robot1", new Pose(xMm, 1000, 0), isSecondSeen, 0.3));
    return new Snapshot(atNs, bodies);
  }
}

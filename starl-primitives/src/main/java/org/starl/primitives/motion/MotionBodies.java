package org.starl.primitives.motion;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * Follows the true bodies of a run, and each robot's last motion command. Decides for {@link
 * MotionSpec} and {@link MotionConformance} which bodies are in an area to avoid, or near a target.
 */
final class MotionBodies {

  /** Receives the path of a body whose command has an area to avoid, piece by piece. */
  interface Path {

    /**
     * @param moved the body's motion at the time when it entered the area; null if it stays outside
     */
    void followed(MotionRecord motion, @Nullable Moved moved);
  }

  private static final double BEHIND_MM = 20;

  /** A body that is farther from the region to avoid may drive at any speed. */
  private static final double NEAR_MM = 500;

  private final double goalRadiusMm;
  private final double rollMm;
  private final Bodies bodies = new Bodies();
  private final Map<RobotId, Moved> drives = new TreeMap<>();
  private final Map<RobotId, Long> standsFromNs = new TreeMap<>();
  private final Map<RobotId, MotionRecord> motions = new TreeMap<>();
  private long commands;

  MotionBodies(MotionParameters p) {
    goalRadiusMm = p.goalRadiusMm();
    rollMm = (1 + p.speedError()) * p.linSpeedMaxMmPerS() * p.reactionMs() / 1e3;
  }

  /** Each robot's last command, unless it was cancelled. */
  Map<RobotId, MotionRecord> motions() {
    return motions;
  }

  /** The last command of {@code robot}; null if there is none, or it was cancelled. */
  @Nullable MotionRecord of(RobotId robot) {
    return motions.get(robot);
  }

  boolean isOnFloor(RobotId robot) {
    return bodies.isOnFloor(robot);
  }

  /** Whether the body drives or turns. */
  boolean isDriving(RobotId robot) {
    Moved drive = drives.get(robot);
    return drive != null
        && bodies.isOnFloor(robot)
        && (drive.linearMmPerS() != 0 || drive.angularRadPerS() != 0);
  }

  /** Since when the body neither drives nor turns; {@code nowNs} if it does. */
  long standsFromNs(RobotId robot, long nowNs) {
    return isDriving(robot) ? nowNs : standsFromNs.getOrDefault(robot, nowNs);
  }

  /** Whether neither the region to avoid nor a wall or another body is right behind the body. */
  boolean mayBackOff(MotionRecord motion, Obstacles walls, long nowNs) {
    Pose pose = bodies.poseAt(motion.robot, nowNs);
    double rad = pose.headingRad();
    Point behind =
        pose.at().minus(new Point(StrictMath.cos(rad), StrictMath.sin(rad)).times(BEHIND_MM));
    double radiusMm = bodies.radiusMm(motion.robot);
    return motion.avoid.distanceMm(pose.at()) > radiusMm + NEAR_MM
        && walls.distanceMm(behind) > radiusMm
        && bodies.robots().stream()
            .filter(other -> !other.equals(motion.robot))
            .allMatch(other ->
                bodies.poseAt(other, nowNs).distanceMm(behind) > radiusMm + bodies.radiusMm(other));
  }

  /** The true pose of a body on the floor. */
  Pose poseAt(RobotId robot, long nowNs) {
    return bodies.poseAt(robot, nowNs);
  }

  double radiusMm(RobotId robot) {
    return bodies.radiusMm(robot);
  }

  /**
   * Whether the robot may report DONE: its body is within goal radius plus its error bound of the
   * target.
   */
  boolean isNear(MotionRecord motion, long nowNs) {
    if (!bodies.isOnFloor(motion.robot)) {
      return false;
    }
    double nearMm = goalRadiusMm + motion.saidErrorMm + BodyPath.ROUNDING_MM;
    return motion.turnsOnly
        || bodies.poseAt(motion.robot, nowNs).distanceMm(motion.target) <= nearMm;
  }

  /**
   * Processes the next event.
   *
   * @param path receives the bodies' paths until then, before the event is used
   */
  void observe(TraceEvent event, Path path) {
    switch (event) {
      case Action action when action.fact() instanceof MotionFact fact -> acted(action, fact, path);
      // A restarted program first sets its motionflag to IDLE.
      case Variable variable when variable.of(MotionFact.FLAG) == MotionFlag.IDLE ->
          end(variable.robot(), variable.timeNs(), path);
      case Moved moved -> {
        follow(moved.robot(), moved.timeNs(), path);
        if (isDriving(moved.robot())) {
          standsFromNs.put(moved.robot(), moved.timeNs());
        }
        bodies.observe(moved);
        drives.put(moved.robot(), moved);
      }
      case Joined joined -> {
        bodies.observe(joined);
        drives.remove(joined.robot());
        standsFromNs.put(joined.robot(), joined.timeNs());
        MotionRecord motion = motions.get(joined.robot());
        if (motion != null) {
          startOf(motion, joined.timeNs());
        }
      }
      case Left left -> {
        follow(left.robot(), left.timeNs(), path);
        bodies.observe(left);
      }
      case Fault fault when fault.name().equals(Fault.CRASH) ->
          end(fault.robot(), fault.timeNs(), path);
      default -> {}
    }
  }

  /** Follows all bodies until the end of the run. */
  void finish(long endNs, Path path) {
    motions.keySet().forEach(robot -> follow(robot, endNs, path));
  }

  private void acted(Action action, MotionFact fact, Path path) {
    switch (fact) {
      case MotionFact.doMove f -> begin(action, f.target(), f.avoid(), false, path);
      case MotionFact.turnTo f -> begin(action, f.target(), new Nowhere(), true, path);
      case MotionFact.motion_stop f -> end(action.robot(), action.timeNs(), path);
      case MotionFact.arrived f -> {
        MotionRecord motion = motions.get(action.robot());
        if (motion != null) {
          motion.saidAt = new Point(f.xMm(), f.yMm());
          motion.saidErrorMm = f.errorMm();
        }
      }
      default -> {}
    }
  }

  private void begin(
      Action action, ItemPosition target, Region avoid, boolean turnsOnly, Path path) {
    RobotId robot = action.robot();
    end(robot, action.timeNs(), path);
    commands++;
    MotionRecord motion =
        new MotionRecord(commands, robot, target.at(), avoid, turnsOnly, action.timeNs());
    motions.put(robot, motion);
    startOf(motion, action.timeNs());
  }

  /** The obligations depend on the body's place at the call, or when it comes to the floor. */
  private void startOf(MotionRecord motion, long nowNs) {
    motion.followedNs = nowNs;
    if (bodies.isOnFloor(motion.robot)) {
      Point start = bodies.poseAt(motion.robot, nowNs).at();
      motion.owesAvoids = motion.avoid.distanceMm(start) > bodies.radiusMm(motion.robot) + rollMm;
    }
  }

  /** Ends the last command: it was replaced, cancelled, or lost with its program. */
  private void end(RobotId robot, long nowNs, Path path) {
    follow(robot, nowNs, path);
    motions.remove(robot);
  }

  private void follow(RobotId robot, long nowNs, Path path) {
    MotionRecord motion = motions.get(robot);
    if (motion == null || !motion.owesAvoids || !bodies.isOnFloor(robot)) {
      return;
    }
    Moved drive = drives.get(robot);
    double mmPerS = drive == null ? 0 : Math.abs(drive.linearMmPerS());
    long entersNs =
        BodyPath.entersNs(bodies, robot, mmPerS, motion.avoid, motion.followedNs, nowNs);
    motion.followedNs = nowNs;
    if (entersNs < 0) {
      path.followed(motion, null);
      return;
    }
    motion.owesAvoids = false;
    double linearMmPerS = drive == null ? 0 : drive.linearMmPerS();
    double angularRadPerS = drive == null ? 0 : drive.angularRadPerS();
    Pose pose = bodies.poseAt(robot, entersNs);
    path.followed(motion, new Moved(entersNs, robot, pose, linearMmPerS, angularRadPerS));
  }
}

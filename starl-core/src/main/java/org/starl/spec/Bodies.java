package org.starl.spec;

import java.util.Collections;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;

/**
 * The true poses of all robots at any time between two events: each body moves along an arc, in
 * closed form, from its last {@code Moved}. For specifications, pictures and viewers.
 */
public final class Bodies {

  private final SortedMap<RobotId, Body> onFloor = new TreeMap<>();

  /** How many of them move: specifications ask at every event whether any does. */
  private int moving;

  /** One body. It is changed in place: it moves often. */
  private static final class Body {
    private double radiusMm;
    private long sinceNs;
    private Pose from;
    private double linearMmPerS;
    private double angularRadPerS;

    Body(Pose from) {
      this.from = from;
    }

    Body copy() {
      Body copy = new Body(from);
      copy.radiusMm = radiusMm;
      copy.moves(sinceNs, from, linearMmPerS, angularRadPerS);
      return copy;
    }

    void moves(long timeNs, Pose pose, double mmPerS, double radPerS) {
      sinceNs = timeNs;
      from = pose;
      linearMmPerS = mmPerS;
      angularRadPerS = radPerS;
    }

    boolean isMoving() {
      return linearMmPerS != 0;
    }
  }

  /** An independent copy of the current state. */
  public Bodies copy() {
    Bodies copy = new Bodies();
    // Copying a sorted map takes linear time.
    copy.onFloor.putAll(onFloor);
    copy.onFloor.replaceAll((robot, body) -> body.copy());
    copy.moving = moving;
    return copy;
  }

  /** Processes the next event. */
  public void observe(TraceEvent event) {
    switch (event) {
      case Joined joined -> {
        Body body = onFloor.get(joined.robot());
        if (body == null) {
          body = new Body(joined.pose());
          onFloor.put(joined.robot(), body);
        }
        body.radiusMm = joined.radiusMm();
        moves(body, joined.timeNs(), joined.pose(), 0, 0);
      }
      case Moved moved ->
          moves(
              body(moved.robot()),
              moved.timeNs(),
              moved.pose(),
              moved.linearMmPerS(),
              moved.angularRadPerS());
      case Left left -> {
        Body body = onFloor.remove(left.robot());
        moving -= body != null && body.isMoving() ? 1 : 0;
      }
      default -> {}
    }
  }

  private void moves(Body body, long timeNs, Pose pose, double mmPerS, double radPerS) {
    moving -= body.isMoving() ? 1 : 0;
    body.moves(timeNs, pose, mmPerS, radPerS);
    moving += body.isMoving() ? 1 : 0;
  }

  /** The robots whose bodies are on the floor, sorted. */
  public Set<RobotId> robots() {
    return Collections.unmodifiableSet(onFloor.keySet());
  }

  public boolean isOnFloor(RobotId robot) {
    return onFloor.containsKey(robot);
  }

  /** Visits bodies. */
  public interface Visitor {

    /**
     * @param pose the true pose
     * @param isMoving whether the body's position changes
     */
    void visit(RobotId robot, Pose pose, double radiusMm, boolean isMoving);
  }

  /**
   * Visits every body on the floor, sorted, with its pose at {@code timeNs}, which is not before
   * the last event.
   */
  public void forEach(long timeNs, Visitor visitor) {
    onFloor.forEach((robot, body) ->
        visitor.visit(robot, poseAt(body, timeNs), body.radiusMm, body.isMoving()));
  }

  /** Whether the position of this body on the floor changes now. */
  public boolean isMoving(RobotId robot) {
    return body(robot).isMoving();
  }

  /** Whether the position of any body on the floor changes now. */
  public boolean isAnyMoving() {
    return moving > 0;
  }

  public double radiusMm(RobotId robot) {
    return body(robot).radiusMm;
  }

  /** The true pose of a body on the floor at {@code timeNs}, which is not before its last event. */
  public Pose poseAt(RobotId robot, long timeNs) {
    return poseAt(body(robot), timeNs);
  }

  private static Pose poseAt(Body body, long timeNs) {
    if (body.linearMmPerS == 0 && body.angularRadPerS == 0) {
      return body.from;
    }
    double seconds = Time.seconds(timeNs - body.sinceNs);
    return Kinematics.after(body.from, body.linearMmPerS, body.angularRadPerS, seconds);
  }

  private Body body(RobotId robot) {
    Body body = onFloor.get(robot);
    if (body == null) {
      throw new IllegalStateException(robot + " has no body on the floor");
    }
    return body;
  }
}

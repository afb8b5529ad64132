package org.starl.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.starl.body.WheelCommand;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Segment;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Timer;
import org.starl.platform.Timers;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * The floor of one run: walls, and the bodies of all robots. Its time is the run's true time. Used
 * by one kernel at a time; its timers belong to the kernel, not to a robot.
 */
public final class World {

  /** Bodies and walls touch at gaps up to this one; they never overlap. */
  public static final double TOUCH_MM = 1;

  /** A contact ends when the gap exceeds this one, because a real bumper has some play. */
  public static final double CLEAR_MM = 2;

  private final Clock clock;
  private final Timers timers;
  private final TraceSink trace;
  private final WorldLimits limits;
  private final Obstacles obstacles;
  private final WallGrid walls;
  private final BodyGrid grid = new BodyGrid(Collider.CELL_MM);
  private final Collider collider;
  private final List<Body> bodies = new ArrayList<>();
  private final Timer wallTimer;
  private double greatestRadiusMm;
  private long changes;

  public World(
      Clock clock, Timers timers, TraceSink trace, WorldLimits limits, Obstacles obstacles) {
    this.clock = clock;
    this.timers = timers;
    this.trace = trace;
    this.limits = limits;
    this.obstacles = obstacles;
    this.walls = new WallGrid(obstacles);
    this.collider = new Collider(this, grid, walls);
    this.wallTimer = timers.timer(this::wallVanished);
    watchWalls();
  }

  /** All initial obstacles, hidden ones included. */
  public Obstacles obstacles() {
    return obstacles;
  }

  /** All bodies, in the order in which they were added. */
  public List<Body> bodies() {
    return List.copyOf(bodies);
  }

  /** Whether a disc at this pose would overlap neither a body nor a wall. */
  public boolean isFree(Pose pose, double radiusMm) {
    return obstacleAt(pose, radiusMm).isEmpty();
  }

  /** The number of contacts so far. */
  public Collisions collisions() {
    return collider.collisions();
  }

  /**
   * Puts a robot's body on the floor, at rest.
   *
   * @throws IllegalArgumentException if the place is not free (the message names the obstacle), or
   *     the radius is not above 0
   */
  public Body add(RobotId id, Pose pose, double radiusMm) {
    return add(id, pose, radiusMm, Body.NO_NUMBER);
  }

  /** As above, with the body's number in the run, for the caller's use. */
  public Body add(RobotId id, Pose pose, double radiusMm, int number) {
    if (!(radiusMm > 0)) {
      throw new IllegalArgumentException(id + " with radius " + radiusMm + " mm: expected above 0");
    }
    String obstacle = obstacleAt(pose, radiusMm);
    if (limits.collisions() && !obstacle.isEmpty()) {
      throw new IllegalArgumentException(
          id + " with radius " + radiusMm + " mm at " + pose + " would overlap " + obstacle);
    }
    greatestRadiusMm = Math.max(greatestRadiusMm, radiusMm);
    Body body = new Body(this, id, pose, radiusMm, number, nowNs());
    bodies.add(body);
    changes++;
    grid.put(body);
    if (trace.isOn()) {
      trace.record(new TraceEvent.Joined(nowNs(), id, body.pose(), radiusMm));
    }
    check(body);
    return body;
  }

  /**
   * Takes a body off the floor; it must not be driven afterwards. No effect if it is already
   * removed.
   */
  public void remove(Body body) {
    if (!bodies.remove(body)) {
      return;
    }
    changes++;
    grid.take(body);
    body.leave();
    collider.forget(body);
    if (trace.isOn()) {
      trace.record(new TraceEvent.Left(nowNs(), body.id()));
    }
  }

  /**
   * Passes each body whose centre is within {@code rangeMm} of {@code center} to {@code visitor}.
   */
  public void forEachWithin(Point center, double rangeMm, Consumer<Body> visitor) {
    long nowNs = nowNs();
    double staleMm = Collider.REACH_MM;
    grid.forEachNear(
        center.xMm(),
        center.yMm(),
        rangeMm + staleMm,
        body -> {
          body.moveTo(nowNs);
          double dx = body.xMm() - center.xMm();
          double dy = body.yMm() - center.yMm();
          if (dx * dx + dy * dy <= rangeMm * rangeMm) {
            visitor.accept(body);
          }
        });
  }

  /** Finds the bodies around a body, again and again. */
  public Surroundings surroundings() {
    return new Surroundings(this, grid, walls);
  }

  /** Whether no wall and no other body cuts the straight line between two bodies' centres. */
  public boolean sees(Body from, Body to) {
    Segment line = new Segment(from.pose().at(), to.pose().at());
    Point middle = line.from().plus(line.to()).times(0.5);
    double halfMm = line.from().distanceMm(line.to()) / 2;
    boolean[] isCut = {false};
    walls.forEachNear(
        middle.xMm(), middle.yMm(), halfMm, nowNs(), wall -> isCut[0] |= wall.crosses(line));
    forEachWithin(
        middle,
        halfMm + greatestRadiusMm,
        body ->
            isCut[0] |=
                body != from
                    && body != to
                    && line.distanceMm(new Point(body.xMm(), body.yMm())) < body.radiusMm());
    return !isCut[0];
  }

  /** All bodies, not a copy. */
  List<Body> all() {
    return bodies;
  }

  int size() {
    return bodies.size();
  }

  /** How often a body came or left. */
  long changes() {
    return changes;
  }

  long nowNs() {
    return clock.nowNs();
  }

  Timer timer(Runnable action) {
    return timers.timer(action);
  }

  boolean hasCollisions() {
    return limits.collisions();
  }

  boolean turnsAtContact() {
    return limits.turnsAtContact();
  }

  double greatestRadiusMm() {
    return greatestRadiusMm;
  }

  void drive(Body body, WheelCommand command) {
    double mmPerS = limits.mmPerS(command.linearMmPerS());
    double radPerS = limits.radPerS(command.angularRadPerS());
    if (mmPerS == body.wantedMmPerS && radPerS == body.wantedRadPerS) {
      return;
    }
    body.wantedMmPerS = mmPerS;
    body.wantedRadPerS = radPerS;
    if (body.isTouching()) {
      check(body);
    } else {
      // The budget is valid for every direction.
      body.moveTo(nowNs());
      move(body, mmPerS, radPerS);
      body.setDue(body.spentNs());
    }
  }

  void check(Body body) {
    collider.check(body);
  }

  /** Sets the body's true motion from now on. */
  void move(Body body, double mmPerS, double radPerS) {
    if (body.setMotion(nowNs(), mmPerS, radPerS) && trace.isOn()) {
      trace.record(new TraceEvent.Moved(nowNs(), body.id(), body.pose(), mmPerS, radPerS));
    }
  }

  private String obstacleAt(Pose pose, double radiusMm) {
    long nowNs = nowNs();
    if (walls.isInside(pose.at(), nowNs)) {
      return "a solid obstacle";
    }
    String[] found = {""};
    walls.forEachNear(
        pose.xMm(),
        pose.yMm(),
        radiusMm,
        nowNs,
        wall -> {
          if (wall.distanceMm(pose.xMm(), pose.yMm()) < radiusMm) {
            found[0] = "a wall";
          }
        });
    forEachWithin(
        pose.at(),
        radiusMm + greatestRadiusMm,
        body -> {
          if (pose.distanceMm(new Point(body.xMm(), body.yMm())) < radiusMm + body.radiusMm()) {
            found[0] = body.id().name();
          }
        });
    return found[0];
  }

  private void watchWalls() {
    long nextNs = walls.nextEndNs(nowNs());
    if (nextNs != Body.NEVER) {
      wallTimer.set(nextNs);
    }
  }

  private void wallVanished() {
    for (Body body : bodies) {
      if (!body.touchedWalls.isEmpty()) {
        body.setDue(nowNs());
      }
    }
    watchWalls();
  }
}

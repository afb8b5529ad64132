package org.starl.sim.world;

import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.geometry.Angles;
import org.starl.time.Time;

/**
 * Prevents overlaps by conservative advancement with <em>budgets</em>: each body may drive its
 * budget, in any direction and at any speed, before it is checked again.
 *
 * <p>Invariant, for any two bodies that do not touch: the gap between them is at least the sum of
 * their budgets plus half of {@link World#TOUCH_MM}; likewise for a body and a wall. Driving
 * preserves it (a budget shrinks by the path driven, a gap by at most the sum of both paths), so a
 * command needs no check of the neighbours. A body that has spent its budget is checked: of each
 * gap it takes a share in proportion to the two speeds, and more if the other body does not use its
 * share.
 *
 * <p>Bodies that touch are checked after each {@link #STEP_MM}, at each command, and when a turning
 * body reaches a bearing of a contact at which its bumps or its freedom change. In one step, a body
 * that does not press can approach only through the curvature of its path: less than 0.01 mm at the
 * Create's limits, far less than the remaining gap.
 */
final class Collider {

  /** The maximum budget, and so the range of a check. */
  static final double REACH_MM = 300;

  static final double CELL_MM = 1000;

  private static final double STEP_MM = 1;
  private static final double KEEP_MM = World.TOUCH_MM / 2;

  /** As if it rolled on a wheel of this radius: the most that robots allow for. */
  private static final double ROLLING_MM = 100;

  /** Well below a right angle: else it would begin and end to press without end. */
  private static final double BESIDE_RAD = 1.3;

  /** The minimum interval of checks of a body that turns in contact. */
  private static final long LEAST_TURN_NS = 1_000;

  private final World world;
  private final BodyGrid grid;
  private final WallGrid walls;

  // The neighbours of the checked body; fields to avoid allocation.
  private Body[] near = new Body[16];
  private double[] nearGapMm = new double[16];
  private int nearCount;
  private Wall[] nearWalls = new Wall[16];
  private double[] nearWallGapMm = new double[16];
  private int nearWallCount;
  private @Nullable Body checked;
  private long nowNs;

  private final BodyGrid.Visitor addNear = this::addNear;
  private final WallGrid.Visitor addNearWall = this::addNearWall;

  private long robotContacts;
  private long wallContacts;

  Collider(World world, BodyGrid grid, WallGrid walls) {
    this.world = world;
    this.grid = grid;
    this.walls = walls;
  }

  /**
   * Checks {@code body} against its neighbours, sets its motion as close to its command as
   * possible, and schedules the next check.
   */
  void check(Body body) {
    nowNs = world.nowNs();
    body.moveTo(nowNs);
    grid.update(body);
    if (!world.hasCollisions()) {
      world.move(body, body.wantedMmPerS, body.wantedRadPerS);
      body.setBudgetMm(nowNs, REACH_MM);
      body.setDue(body.spentNs());
      return;
    }
    look(body);
    updateTouched(body);
    boolean presses = presses(body);
    double rollsRadPerS = presses && world.turnsAtContact() ? rollsRadPerS(body) : 0;
    world.move(body, presses ? 0 : body.wantedMmPerS, body.wantedRadPerS + rollsRadPerS);
    share(body);
    body.setDue(Math.min(body.spentNs(), nextEdgeNs(body)));
    body.setBumps(bumps(body));
    for (Body other : body.touchedBodies) {
      other.setBumps(bumps(other));
      if (presses(other) != other.isBlocked()) {
        other.setDue(nowNs);
      }
    }
  }

  /** The collisions so far. */
  Collisions collisions() {
    return new Collisions(robotContacts, wallContacts);
  }

  /** Removes {@code body}; bodies that touched it may become free. */
  void forget(Body body) {
    for (Body other : body.touchedBodies) {
      other.touchedBodies.remove(body);
      other.setDue(world.nowNs());
    }
    body.touchedBodies.clear();
    body.touchedWalls.clear();
  }

  private void look(Body body) {
    checked = body;
    nearCount = 0;
    nearWallCount = 0;
    // The grid has the position of each body at its last check; the path since then plus the budget
    // is at most REACH_MM.
    double rangeMm = body.radiusMm() + world.greatestRadiusMm() + 2 * REACH_MM + World.TOUCH_MM;
    grid.forEachNear(body.xMm(), body.yMm(), rangeMm, addNear);
    double wallRangeMm = body.radiusMm() + REACH_MM + World.TOUCH_MM;
    walls.forEachNear(body.xMm(), body.yMm(), wallRangeMm, nowNs, addNearWall);
    checked = null;
  }

  private void addNear(Body other) {
    Body body = checked;
    if (body == null || other == body) {
      return;
    }
    other.moveTo(nowNs);
    double gapMm = gapMm(body, other);
    if (gapMm > 2 * REACH_MM + World.TOUCH_MM) {
      return;
    }
    if (nearCount == near.length) {
      near = Arrays.copyOf(near, 2 * nearCount);
      nearGapMm = Arrays.copyOf(nearGapMm, 2 * nearCount);
    }
    near[nearCount] = other;
    nearGapMm[nearCount] = gapMm;
    nearCount++;
  }

  private void addNearWall(Wall wall) {
    Body body = checked;
    if (body == null) {
      return;
    }
    double gapMm = gapMm(body, wall);
    if (gapMm > REACH_MM + World.TOUCH_MM) {
      return;
    }
    if (nearWallCount == nearWalls.length) {
      nearWalls = Arrays.copyOf(nearWalls, 2 * nearWallCount);
      nearWallGapMm = Arrays.copyOf(nearWallGapMm, 2 * nearWallCount);
    }
    nearWalls[nearWallCount] = wall;
    nearWallGapMm[nearWallCount] = gapMm;
    nearWallCount++;
  }

  private void updateTouched(Body body) {
    List<Body> bodies = body.touchedBodies;
    for (int i = bodies.size() - 1; i >= 0; i--) {
      Body other = bodies.get(i);
      other.moveTo(nowNs);
      if (gapMm(body, other) > World.CLEAR_MM) {
        bodies.remove(i);
        other.touchedBodies.remove(body);
        other.setDue(nowNs);
      }
    }
    body.touchedWalls.removeIf(wall -> !wall.standsAt(nowNs) || gapMm(body, wall) > World.CLEAR_MM);
    for (int i = 0; i < nearCount; i++) {
      if (nearGapMm[i] <= World.TOUCH_MM && !bodies.contains(near[i])) {
        bodies.add(near[i]);
        near[i].touchedBodies.add(body);
        robotContacts++;
      }
    }
    for (int i = 0; i < nearWallCount; i++) {
      if (nearWallGapMm[i] <= World.TOUCH_MM && !body.touchedWalls.contains(nearWalls[i])) {
        body.touchedWalls.add(nearWalls[i]);
        wallContacts++;
      }
    }
  }

  /** Takes the maximum budget that the gaps around {@code body} allow. */
  private void share(Body body) {
    double speed = body.speedMmPerS();
    // A body at rest needs no budget; it keeps the rest, which saves a check when it starts.
    double budgetMm = speed == 0 ? body.budgetMm(nowNs) : REACH_MM;
    for (int i = 0; i < nearWallCount; i++) {
      double gapMm = nearWallGapMm[i];
      budgetMm = Math.min(budgetMm, gapMm > World.TOUCH_MM ? gapMm - KEEP_MM : STEP_MM);
    }
    for (int i = 0; i < nearCount; i++) {
      budgetMm = Math.min(budgetMm, allowedMm(speed, near[i], nearGapMm[i]));
    }
    body.setBudgetMm(nowNs, budgetMm);
    for (int i = 0; i < nearCount; i++) {
      double gapMm = nearGapMm[i];
      double leftMm = gapMm > World.TOUCH_MM ? gapMm - KEEP_MM - budgetMm : STEP_MM;
      Body other = near[i];
      if (other.budgetMm(nowNs) > leftMm) {
        other.setBudgetMm(nowNs, leftMm);
        other.setDue(Math.min(other.dueNs, other.spentNs()));
      }
    }
  }

  private double allowedMm(double speed, Body other, double gapMm) {
    if (gapMm <= World.TOUCH_MM) {
      return STEP_MM;
    }
    double freeMm = gapMm - KEEP_MM;
    double speeds = speed + other.speedMmPerS();
    double shareMm = speeds == 0 ? 0 : freeMm * (speed / speeds);
    return Math.max(shareMm, freeMm - other.budgetMm(nowNs));
  }

  /** A body that pushes against one thing rolls along it, until that is beside it. */
  private static double rollsRadPerS(Body body) {
    if (body.wantedMmPerS < 0 || body.touchedBodies.size() + body.touchedWalls.size() > 1) {
      return 0;
    }
    double bearingRad =
        body.touchedBodies.isEmpty()
            ? bearingRad(body, body.touchedWalls.get(0))
            : bearingRad(body, body.touchedBodies.get(0));
    return Math.abs(bearingRad) > BESIDE_RAD
        ? 0
        : StrictMath.copySign(body.wantedMmPerS / ROLLING_MM, -bearingRad);
  }

  private boolean presses(Body body) {
    for (Body other : body.touchedBodies) {
      if (presses(body, other)) {
        return true;
      }
    }
    for (Wall wall : body.touchedWalls) {
      if (presses(body, wall)) {
        return true;
      }
    }
    return false;
  }

  private static boolean presses(Body body, Body other) {
    return body.wantedMmPerS != 0
        && Touch.presses(body.wantedMmPerS, bearingRad(body, other), gapMm(body, other));
  }

  private static boolean presses(Body body, Wall wall) {
    return body.wantedMmPerS != 0
        && Touch.presses(body.wantedMmPerS, bearingRad(body, wall), gapMm(body, wall));
  }

  private static Bumps bumps(Body body) {
    boolean left = false;
    boolean right = false;
    for (Body other : body.touchedBodies) {
      if (presses(body, other) || presses(other, body)) {
        double bearingRad = bearingRad(body, other);
        left |= Touch.pressesLeft(bearingRad);
        right |= Touch.pressesRight(bearingRad);
      }
    }
    for (Wall wall : body.touchedWalls) {
      if (presses(body, wall)) {
        double bearingRad = bearingRad(body, wall);
        left |= Touch.pressesLeft(bearingRad);
        right |= Touch.pressesRight(bearingRad);
      }
    }
    return Bumps.of(left, right);
  }

  private long nextEdgeNs(Body body) {
    double radPerS = body.angularRadPerS();
    if (radPerS == 0 || !body.isTouching()) {
      return Body.NEVER;
    }
    double seconds = Double.POSITIVE_INFINITY;
    for (Body other : body.touchedBodies) {
      seconds = Math.min(seconds, Touch.secondsToEdge(bearingRad(body, other), radPerS));
    }
    for (Wall wall : body.touchedWalls) {
      seconds = Math.min(seconds, Touch.secondsToEdge(bearingRad(body, wall), radPerS));
    }
    double ns = Math.ceil(seconds * Time.NS_PER_S);
    return ns > Body.LONGEST_NS ? Body.NEVER : nowNs + Math.max(LEAST_TURN_NS, (long) ns);
  }

  private static double gapMm(Body body, Body other) {
    double dx = other.xMm() - body.xMm();
    double dy = other.yMm() - body.yMm();
    return Math.sqrt(dx * dx + dy * dy) - body.radiusMm() - other.radiusMm();
  }

  private static double gapMm(Body body, Wall wall) {
    return wall.distanceMm(body.xMm(), body.yMm()) - body.radiusMm();
  }

  private static double bearingRad(Body body, Body other) {
    return bearingRad(body, other.xMm(), other.yMm());
  }

  private static double bearingRad(Body body, Wall wall) {
    double x = body.xMm();
    double y = body.yMm();
    return bearingRad(body, wall.nearestX(x, y), wall.nearestY(x, y));
  }

  private static double bearingRad(Body body, double x, double y) {
    double direction = StrictMath.atan2(y - body.yMm(), x - body.xMm());
    return Angles.difference(direction, body.headingRad());
  }
}

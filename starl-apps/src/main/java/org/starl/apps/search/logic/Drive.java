package org.starl.apps.search.logic;

import java.util.BitSet;
import org.starl.GlobalVarHolder;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.FewerCorners;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.StraightFirst;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubeFlag;
import org.starl.primitives.paths.TubeSettings;

/**
 * Drives a searcher to one place after another, each time in a reach tube of its own. Strand only.
 */
public final class Drive {

  private static final long NS_PER_MS = 1_000_000;
  private static final double GOAL_RADIUS_MM = 10;

  /**
   * A tube is wider by this distance. With 80 mm, robots stay so far from walls that they do not
   * see the corners of rooms; with 60 mm they do, in houses of up to 12 rooms.
   */
  private static final double STEP_MM = 60;

  /** A motion that fails, by a bump say, is begun again so often. */
  private static final int RESTARTS = 3;

  /** Places are cells: a way between two tubes need not lead over their centres. */
  private static final double ROUGH_MM = House.CELL_MM / 2.0;

  /** Points of a tube that are reserved for the corners of its path. */
  private static final int CORNERS = 12;

  /** Most ways are within a room. */
  private static final double FIRST_LOOK_MM = 1_000;

  private static final double PLANNERS_CHORDS = 1.005;
  private static final double PLANNERS_ROUNDING_MM = 4;

  private final GlobalVarHolder gvh;
  private final DistributedPathPlanning paths;
  private Point target = new Point(0, 0);
  private long patienceNs;
  private long waitingSinceNs;
  private int restarts;
  private boolean isBlocked;

  /** The state of a drive. */
  enum State {
    UNDER_WAY,
    ARRIVED,
    /** It stands somewhere on the way. */
    BLOCKED
  }

  /**
   * Changes how this robot moves: see {@link #motion}.
   *
   * @param xid the name of the search
   */
  Drive(GlobalVarHolder gvh, String xid, Rectangle bounds) {
    this.gvh = gvh;
    gvh.plat.moat.setParameters(motion(gvh.plat.moat.parameters()));
    paths =
        new DistributedPathPlanning(
            gvh,
            xid,
            gvh.id.participants(),
            new StraightFirst(new FewerCorners(new LocalPlanner(FIRST_LOOK_MM))),
            bounds,
            tubes(bounds));
  }

  /**
   * Tubes for a house: a way as long as its width and height together fits one tube of {@link
   * Tube#MAX_POINTS}. The shorter a tube's parts the narrower they can be; with parts of up to a
   * metre, robots may start 500 mm apart.
   */
  private static TubeSettings tubes(Rectangle bounds) {
    double longestMm = bounds.xMaxMm() - bounds.xMinMm() + bounds.yMaxMm() - bounds.yMinMm();
    int legMm = (int) StrictMath.ceil(longestMm / (Tube.MAX_POINTS - CORNERS));
    return new TubeSettings(20, Math.max(1_000, legMm), 120_000, 200, 2_000, 500, 4_000);
  }

  /** How a searcher with such a body moves: slower if its reaction time is long. */
  public static MotionParameters motion(MotionParameters body) {
    return DistributedPathPlanning.slowed(
        body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).constantSpeed().build(), STEP_MM);
  }

  /**
   * How far a searcher's centre stays from every wall: the radius of its tube, what its planner
   * spends on fewer corners, and rounding.
   */
  public static double clearanceMm(MotionParameters body, Rectangle bounds) {
    double radiusMm = DistributedPathPlanning.radiusMm(motion(body), tubes(bounds), STEP_MM);
    return (radiusMm + FewerCorners.SPARE_MM) * PLANNERS_CHORDS + PLANNERS_ROUNDING_MM;
  }

  /**
   * Sets out for a place instead of the one before.
   *
   * @param patienceMs how long it waits for a free way; under way nothing holds it up
   */
  void to(Point place, long patienceMs) {
    stop();
    target = place;
    patienceNs = patienceMs * NS_PER_MS;
    restarts = 0;
    isBlocked = false;
    begin();
  }

  void stop() {
    paths.stop();
  }

  /** The place for which it has set out last. */
  Point target() {
    return target;
  }

  /**
   * The places of the house to which no way leads now past what others hold, as far as is known.
   */
  BitSet barred(House house) {
    BitSet open = house.places();
    for (Capsule capsule : paths.taken()) {
      house.bar(capsule.axis(), capsule.radiusMm() + paths.radiusMm() - ROUGH_MM, open);
    }
    BitSet barred = house.places();
    barred.andNot(house.reachable(gvh.gps.pose().at(), open));
    return barred;
  }

  /** Checks the state of the drive; to be called every period. */
  State check() {
    if (isBlocked) {
      return State.BLOCKED;
    }
    TubeFlag flag = paths.tubeflag().get();
    switch (flag) {
      case DONE -> {
        return State.ARRIVED;
      }
      case PLANNING, CLAIMING -> {
        if (gvh.plat.clock.nowNs() - waitingSinceNs > patienceNs) {
          stop();
          isBlocked = true;
        }
      }
      case MOVING -> waitingSinceNs = gvh.plat.clock.nowNs();
      case FAIL, IDLE -> {
        isBlocked = paths.failure().get() != TubeFailure.MOTION || restarts == RESTARTS;
        if (!isBlocked) {
          restarts++;
          begin();
        }
      }
    }
    return isBlocked ? State.BLOCKED : State.UNDER_WAY;
  }

  private void begin() {
    waitingSinceNs = gvh.plat.clock.nowNs();
    paths.goTo(new ItemPosition("place", target.xMm(), target.yMm()));
  }
}

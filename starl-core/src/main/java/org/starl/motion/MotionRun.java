package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.random.Rng;

/**
 * One motion command with its safety checks: the automaton trusts its pose; this class stops the
 * wheels without a recent fix or a certain position, keeps the body out of the region to avoid, and
 * fails if the robot is stuck or too slow, so that every motion ends. Pure: the result of a step
 * depends only on the arguments of the steps so far.
 */
final class MotionRun {

  /** So often a new way is planned where the region to avoid is in the way. */
  private static final int MOST_PLANS = 4;

  private final MotionParameters p;
  private final Rng rng;
  private final Region avoid;
  private final Supplier<Region> retreatAvoid;
  private final AvoidGuard guard;
  private final long startNs;

  /** The ends of the legs. */
  private List<Point> way;

  /** The number of the leg that the automaton drives. */
  private int leg;

  private MotionAutomaton automaton;
  private ProgressWatch watch;
  private @Nullable WayPlanner planner;
  private @Nullable Supplier<@Nullable List<Point>> plan;
  private boolean wantsPlan;
  private int plans;

  private MotionFlag status = MotionFlag.MOVING;
  private @Nullable MotionFailure failure;
  private long lastStepNs;
  private long lastCertainNs;
  private long deadlineNs = Long.MAX_VALUE;
  private @Nullable AvoidGuard retreatGuard;
  private boolean heldBack;
  private long heldBackNs;
  private boolean wheelsTurn;

  private MotionRun(
      Point target,
      Region avoid,
      Supplier<Region> retreatAvoid,
      MotionParameters p,
      Rng rng,
      MotionAutomaton automaton,
      long nowNs) {
    this.rng = rng;
    this.way = List.of(target);
    this.avoid = avoid;
    this.retreatAvoid = retreatAvoid;
    this.p = p;
    this.automaton = automaton;
    this.guard = new AvoidGuard(avoid, p);
    this.watch = new ProgressWatch(p);
    this.startNs = nowNs;
    this.lastStepNs = nowNs;
    this.lastCertainNs = nowNs;
  }

  /**
   * @param retreatAvoid also to be avoided while it backs off after a bump; read when it begins to
   */
  static MotionRun goTo(
      Point target,
      Region avoid,
      Supplier<Region> retreatAvoid,
      MotionParameters p,
      Rng rng,
      long nowNs) {
    MotionAutomaton automaton = MotionAutomaton.goTo(target, avoid instanceof Nowhere, p, rng);
    MotionRun run = new MotionRun(target, avoid, retreatAvoid, p, rng, automaton, nowNs);
    if (run.guard.forbids(target)) {
      run.fail(MotionFailure.TARGET_FORBIDDEN);
    }
    return run;
  }

  /**
   * @param newPlanner asked for a way at the first step with a certain position; null: straight
   */
  MotionRun onWayOf(@Nullable WayPlanner newPlanner) {
    planner = newPlanner;
    wantsPlan = true;
    return this;
  }

  static MotionRun turnTo(
      Point target, Supplier<Region> retreatAvoid, MotionParameters p, Rng rng, long nowNs) {
    MotionAutomaton automaton = MotionAutomaton.turnTo(target, p, rng);
    return new MotionRun(target, new Nowhere(), retreatAvoid, p, rng, automaton, nowNs);
  }

  MotionFlag status() {
    return status;
  }

  MotionState state() {
    return automaton.state();
  }

  /** Why it failed; null if it did not. */
  @Nullable MotionFailure failure() {
    return failure;
  }

  /**
   * Whether more steps are needed: the motion is going on, or the robot drives on past the target.
   */
  boolean needsSteps() {
    return status == MotionFlag.MOVING || wheelsTurn;
  }

  /**
   * Computes the wheel command until the next step.
   *
   * @param isContradicted whether the newest fixes contradict the commands
   * @param lingering earlier commands that may still be in effect
   */
  WheelCommand step(
      Location location,
      boolean isContradicted,
      Bumps bumps,
      LingeringSpeeds lingering,
      long nowNs) {
    WheelCommand command =
        status == MotionFlag.FAIL
            ? WheelCommand.STOP
            : decide(location, isContradicted, bumps, lingering, nowNs);
    if (command.isStop()) {
      watch.excuse(nowNs - lastStepNs);
    }
    lastStepNs = nowNs;
    wheelsTurn = !command.isStop();
    return command;
  }

  private WheelCommand decide(
      Location location,
      boolean isContradicted,
      Bumps bumps,
      LingeringSpeeds lingering,
      long nowNs) {
    if (status == MotionFlag.DONE && (!wheelsTurn || bumps.any())) {
      return WheelCommand.STOP;
    }
    if (status == MotionFlag.MOVING && nowNs >= deadlineNs) {
      return fail(automaton.goesOnAfterBump() ? MotionFailure.BUMPED : MotionFailure.TOO_SLOW);
    }
    if (!(location instanceof Location.Known at)) {
      return waitForFix(nowNs - startNs, MotionFailure.NO_FIX);
    }
    if (at.errorMm() > p.maxErrorMm()) {
      return waitForFix(
          nowNs - lastCertainNs,
          isContradicted ? MotionFailure.CONTRADICTED : MotionFailure.UNCERTAIN);
    }
    lastCertainNs = nowNs;
    if (deadlineNs == Long.MAX_VALUE) {
      deadlineNs = startNs + p.longestMs(leftMm(at)) * NS_PER_MS;
    }
    if (at.fixAgeNs() > p.maxFixAgeMs() * NS_PER_MS) {
      return waitForFix(
          Math.min(at.fixAgeNs(), nowNs - startNs),
          isContradicted ? MotionFailure.CONTRADICTED : MotionFailure.NO_FIX);
    }
    if (hasNoWay(at, nowNs)) {
      return WheelCommand.STOP;
    }
    boolean wasAside = automaton.state().isManeuver();
    WheelCommand wanted = automaton.step(at.pose(), bumps, nowNs);
    if (wasAside && !automaton.state().isManeuver() && way.size() > 1) {
      // Else it would go back to the corners that it has passed aside.
      wantsPlan = plans < MOST_PLANS;
    }
    while (automaton.status() == MotionFlag.DONE && leg < way.size() - 1) {
      begin(leg + 1);
      wanted = automaton.step(at.pose(), bumps, nowNs);
    }
    if (automaton.status() == MotionFlag.FAIL) {
      return fail(MotionFailure.BUMPED);
    }
    if (status == MotionFlag.MOVING) {
      status = automaton.status();
    }
    return status == MotionFlag.MOVING && updateWatch(at)
        ? fail(automaton.goesOnAfterBump() ? MotionFailure.BUMPED : MotionFailure.NO_PROGRESS)
        : keepOut(guardOf(wanted).limit(wanted, at, bumps, lingering), wanted, nowNs);
  }

  /** Whether the way is still being planned, or there is none: then the motion has failed. */
  private boolean hasNoWay(Location.Known at, long nowNs) {
    if (planner != null && wantsPlan) {
      wantsPlan = false;
      plans++;
      plan = planner.plan(at);
    }
    if (plan == null || status != MotionFlag.MOVING) {
      return false;
    }
    List<Point> corners = plan.get();
    if (corners == null) {
      return true;
    }
    plan = null;
    if (corners.isEmpty()) {
      fail(MotionFailure.NO_WAY);
      return true;
    }
    if (corners.size() > 1 || plans > 1) {
      way = corners;
      begin(0);
      watch = new ProgressWatch(p);
    }
    if (corners.size() > 1) {
      deadlineNs = nowNs + p.longestMs(leftMm(at)) * NS_PER_MS;
    }
    return false;
  }

  /** Straight, as arcs would leave the way. */
  private void begin(int newLeg) {
    leg = newLeg;
    boolean isLast = leg == way.size() - 1;
    double nearMm = isLast ? p.goalRadiusMm() : p.cornerRadiusMm();
    MotionParameters straight = p.toBuilder().enableArcing(false).goalRadiusMm(nearMm).build();
    automaton = MotionAutomaton.goTo(way.get(leg), false, straight, rng);
  }

  private double leftMm(Location.Known at) {
    double mm = at.pose().distanceMm(way.get(leg));
    for (int i = leg + 1; i < way.size(); i++) {
      mm += way.get(i - 1).distanceMm(way.get(i));
    }
    return mm;
  }

  /** The region of a retreat is that of its begin: what it leaves on its way stays allowed. */
  private AvoidGuard guardOf(WheelCommand wanted) {
    if (wanted.linearMmPerS() >= 0) {
      retreatGuard = null;
      return guard;
    }
    if (retreatGuard == null) {
      Region others = retreatAvoid.get();
      boolean isAlone = others instanceof Nowhere;
      retreatGuard = isAlone ? guard : new AvoidGuard(Union.of(avoid, others), p);
    }
    return retreatGuard;
  }

  private WheelCommand waitForFix(long sinceNs, MotionFailure why) {
    return sinceNs >= p.failFixAgeMs() * NS_PER_MS && status == MotionFlag.MOVING
        ? fail(why)
        : WheelCommand.STOP;
  }

  /** Returns whether the motion is stuck. */
  private boolean updateWatch(Location.Known at) {
    Pose pose = at.pose();
    double towardsRad = way.get(leg).minus(pose.at()).angleRad();
    double bearingRad = Angles.difference(towardsRad, pose.headingRad());
    return watch.update(at, leftMm(at), bearingRad);
  }

  private WheelCommand keepOut(WheelCommand limited, WheelCommand wanted, long nowNs) {
    if (!limited.isStop() || wanted.isStop()) {
      heldBack = false;
      return limited;
    }
    if (!heldBack) {
      heldBack = true;
      heldBackNs = nowNs;
    }
    // The error bound of a standing body shrinks with the next fix: wait for it before failing.
    if (nowNs - heldBackNs < p.avoidPatienceMs() * NS_PER_MS || status != MotionFlag.MOVING) {
      return WheelCommand.STOP;
    }
    if (automaton.givesUpManeuver()) {
      heldBack = false;
      return WheelCommand.STOP;
    }
    if (planner != null && plans < MOST_PLANS && wanted.linearMmPerS() > 0) {
      wantsPlan = true;
      heldBack = false;
      return WheelCommand.STOP;
    }
    return fail(wanted.linearMmPerS() < 0 ? MotionFailure.BUMPED : MotionFailure.IN_THE_WAY);
  }

  private WheelCommand fail(MotionFailure why) {
    status = MotionFlag.FAIL;
    failure = why;
    return WheelCommand.STOP;
  }
}

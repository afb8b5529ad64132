// Longer than 500 lines because the lemmas of a motion share its record and the bodies that they
// follow.
package org.starl.primitives.motion;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFailure;
import org.starl.motion.MotionFlag;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FlagCheck;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of motion (paper, section 4.1), after the package's contract: {@code avoids},
 * {@code arrives}, {@code told} and {@code motionflag}. It uses the true bodies. It watches {@code gvh.plat.moat}, and
 * so both {@link MotionControl} and apps that use the motion automaton directly.
 */
public final class MotionSpec extends LemmaMonitor {

  static final String AVOIDS = "motion.avoids";
  static final String ARRIVES = "motion.arrives";
  static final String TOLD = "motion.told";
  static final String LOCATED = "motion.located";
  static final String FLAG = "motion.motionflag";

  private static final long NEVER = Long.MAX_VALUE;

  /**
   * A correct motion's largest deviation from the straight line; its arcs begin within 25 degrees.
   */
  private static final double SWERVE_MM = 100;

  /** A clock without faults counts less time than this wrongly in a second. */
  private static final long CLOCK_MS = 1;

  /** The faults of clocks and of computing time, by their names in the trace. */
  private static final Set<String> TIME_FAULTS = Set.of("compute", "drift", "skew");

  private final MotionParameters p;
  private final double marginMm;
  private final MotionBodies bodies;
  private final FixFaults fixes = new FixFaults();
  private final FlagCheck<MotionFlag> flag = new FlagCheck<>(MotionFact.FLAG, FLAG);

  // The numbers of active faults, and of active faults that affect time.
  private int faults;
  private int faultsOfTime;
  private long firstDeadlineNs = NEVER;

  // From when a robot stands, because its motion has failed or was cancelled.
  private final SortedMap<RobotId, Long> standsFromNs = new TreeMap<>();
  private long firstStandsNs = NEVER;
  private boolean isRealTime;

  private final long heldUpMs;
  private Obstacles walls = Obstacles.NONE;
  private boolean isBackingOff;
  private boolean isLocated;

  /** For robots with the default motion parameters, and position errors below 50 mm. */
  public MotionSpec() {
    this(MotionParameters.DEFAULT);
  }

  /** For position errors below 50 mm. */
  public MotionSpec(MotionParameters parameters) {
    this(parameters, 50);
  }

  /**
   * @param parameters how the robots move: goal radius, speeds, reaction time, and the times after
   *     which a motion fails
   * @param positionErrorMm {@code arrives} is owed if the region to avoid leaves room for this
   *     error, in mm
   */
  public MotionSpec(MotionParameters parameters, double positionErrorMm) {
    p = parameters;
    bodies = new MotionBodies(parameters);
    double mostMmPerS = (1 + p.speedError()) * p.linSpeedMaxMmPerS();
    double rollMm = mostMmPerS * p.reactionMs() / 1e3;
    double stepMm = mostMmPerS * p.automatonPeriodMs() / 1e3;
    marginMm = SWERVE_MM + 2 * (positionErrorMm + rollMm + stepMm);
    // It waits for a fix, for a certain position and for the region to avoid, and backs off in
    // vain.
    long waitsMs =
        2 * p.failFixAgeMs() + p.avoidPatienceMs() + p.collisionBackMs() + p.reactionMs();
    boolean pushes = p.collisionPolicy() == CollisionPolicy.BUMPERCARS;
    heldUpMs = waitsMs + (pushes ? p.stuckAfterMs() : 0);
    lemma(AVOIDS, "No part of a robot enters the area that its move must avoid.");
    progress(ARRIVES, "A move without an obstacle succeeds.");
    progress(
        TOLD,
        "A move ends in time, at its goal or failed, and not early; after a failure or a stop the robot"
            + " stands.");
    lemma(FLAG, "The variable motionflag says how the latest command stands.");
  }

  /** Of robots that drive in tubes: {@code arrives} is not owed in so little room. */
  public MotionSpec inTubes() {
    never(ARRIVES, "robots drive in tubes, where a move need not succeed at the first try");
    return this;
  }

  /** Of robots in a lane that get a new target as they drive: {@code arrives} is not owed. */
  public MotionSpec inLanes() {
    never(ARRIVES, "cars get new targets as they drive, in lanes without room around a move");
    return this;
  }

  /**
   * Of robots that nothing keeps from backing off but other bodies, these walls, and the region to
   * avoid: with the policy to do so, each does.
   */
  public MotionSpec backingOff(Obstacles around) {
    walls = around;
    isBackingOff = p.collisionPolicy() == CollisionPolicy.USE_COLBACK;
    return this;
  }

  /**
   * Also requires that robots are where they believe to be, and that a motion fails for its fixes only
   * after a fault of them: of fixes and wheels within their bounds, but for such faults.
   */
  public MotionSpec located() {
    lemma(
        LOCATED,
        "A robot is within its error bounds of the place and the heading that it believes to have.");
    isLocated = true;
    return this;
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new MotionConformance(p));
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    flag.observe(event, report);
    checkDeadlines(event.timeNs(), report);
    checkStanding(event.timeNs(), report);
    if (event instanceof Moved moved) {
      moves(moved, report);
    }
    bodies.observe(event, (motion, moved) -> followed(motion, moved, report));
    switch (event) {
      case Action action -> acted(action, report);
      case Variable variable -> {
        checkLocated(variable, report);
        flagged(variable, report);
      }
      case Moved moved when standsFromNs.getOrDefault(moved.robot(), NEVER) < moved.timeNs() ->
          checkStands(moved.robot(), moved.timeNs(), report);
      case Joined joined -> startOf(joined.robot(), joined.timeNs());
      case Fault fault -> failing(fault);
      default -> {}
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    checkDeadlines(endNs, report);
    checkStanding(endNs, report);
    bodies.finish(endNs, (motion, moved) -> followed(motion, moved, report));
  }

  private void moves(Moved moved, Report report) {
    MotionRecord motion = bodies.of(moved.robot());
    if (motion != null) {
      checkHeldUp(motion, moved.timeNs(), report);
      motion.hasBackedOff |= moved.linearMmPerS() < 0;
    }
  }

  private void acted(Action action, Report report) {
    if (action.fact() instanceof MotionFact fact) {
      checkFlag(action, fact, report);
    }
    switch (action.fact()) {
      case MotionFact.doMove f -> startOf(action.robot(), action.timeNs());
      case MotionFact.turnTo f -> startOf(action.robot(), action.timeNs());
      case MotionFact.planned f -> planned(f.way(), action.robot(), action.timeNs());
      case MotionFact.failed f -> {
        MotionRecord motion = bodies.of(action.robot());
        if (motion != null) {
          failed(motion, f.reason(), action.timeNs(), report);
        }
      }
      default -> {}
    }
  }

  private void checkFlag(Action action, MotionFact fact, Report report) {
    MotionFlag next =
        switch (fact) {
          case MotionFact.doMove f -> MotionFlag.MOVING;
          case MotionFact.turnTo f -> MotionFlag.MOVING;
          case MotionFact.arrived f -> MotionFlag.DONE;
          case MotionFact.failed f -> MotionFlag.FAIL;
          case MotionFact.motion_stop f -> MotionFlag.IDLE;
          case MotionFact.doDrive f -> MotionFlag.IDLE;
          case MotionFact.planned f -> null;
          case MotionFact.gotopoint f -> null;
          case MotionFact.do_move f -> null;
        };
    if (next != null) {
      ProcessKey key = new ProcessKey(action.source(), action.robot());
      flag.says(key, action, next::equals, report);
    }
  }

  /** The obligations depend on the body's place at the call, or when it comes to the floor. */
  private void startOf(RobotId robot, long nowNs) {
    MotionRecord motion = bodies.of(robot);
    if (motion == null) {
      return;
    }
    motion.hasTrueClock = faultsOfTime == 0;
    motion.isCalm = faults == 0;
    double distanceMm = 0;
    if (bodies.isOnFloor(robot)) {
      Point start = bodies.poseAt(robot, nowNs).at();
      distanceMm = start.distanceMm(motion.target);
      motion.owesArrives =
          faults == 0
              && !motion.turnsOnly
              && Detour.isClear(
                  start,
                  motion.target,
                  bodies.radiusMm(robot) + p.goalRadiusMm() + marginMm,
                  motion.avoid::distanceMm);
    }
    setDeadline(motion, distanceMm, motion.startNs);
  }

  private void setDeadline(MotionRecord motion, double distanceMm, long fromNs) {
    long longestMs = p.longestMs(distanceMm + p.maxErrorMm());
    motion.deadlineNs = fromNs + (longestMs + stepMs()) * NS_PER_MS;
    double leastMm = Math.max(0, distanceMm - p.maxErrorMm());
    motion.slowFromNs = fromNs + p.longestMs(leastMm) * NS_PER_MS;
    firstDeadlineNs = Math.min(firstDeadlineNs, deadlineNs(motion));
  }

  private long stepMs() {
    return 2 * p.automatonPeriodMs() + p.reactionMs();
  }

  /** Its own, or earlier: it fails if no fix comes. */
  private long deadlineNs(MotionRecord motion) {
    long blindNs = fixes.blindFromNs(motion.robot, NEVER);
    if (blindNs == NEVER || !isLocated) {
      return motion.deadlineNs;
    }
    long patienceMs = p.maxFixAgeMs() + p.failFixAgeMs() + stepMs();
    long failsNs = Math.max(blindNs, motion.triesFromNs) + patienceMs * NS_PER_MS;
    return Math.min(motion.deadlineNs, failsNs);
  }

  /** From then on the motion has the time for its way. */
  private void planned(List<Point> way, RobotId robot, long nowNs) {
    MotionRecord motion = bodies.of(robot);
    if (motion != null) {
      motion.triesFromNs = nowNs;
      Point at = bodies.isOnFloor(robot) ? bodies.poseAt(robot, nowNs).at() : motion.target;
      double lengthMm = 0;
      for (Point corner : way) {
        lengthMm += at.distanceMm(corner);
        at = corner;
      }
      setDeadline(motion, lengthMm, nowNs);
    }
  }

  private void checkStanding(long nowNs, Report report) {
    if (nowNs <= firstStandsNs) {
      return;
    }
    firstStandsNs = NEVER;
    standsFromNs.forEach((robot, fromNs) -> {
      if (fromNs < nowNs) {
        checkStands(robot, nowNs, report);
      } else {
        firstStandsNs = Math.min(firstStandsNs, fromNs);
      }
    });
  }

  private void checkStands(RobotId robot, long nowNs, Report report) {
    if (bodies.isDriving(robot) && !isRealTime) {
      String detail = "drives, although its motion has failed or was cancelled";
      report.violated(TOLD, nowNs, List.of(robot), detail);
    }
  }

  private void flagged(Variable variable, Report report) {
    MotionFlag value = variable.of(MotionFact.FLAG);
    if (value == null) {
      return;
    }
    flag.shows(variable, report);
    if (value == MotionFlag.FAIL || value == MotionFlag.IDLE) {
      long fromNs = variable.timeNs() + p.reactionMs() * NS_PER_MS;
      standsFromNs.put(variable.robot(), fromNs);
      firstStandsNs = Math.min(firstStandsNs, fromNs);
    } else {
      standsFromNs.remove(variable.robot());
    }
    MotionRecord motion = bodies.of(variable.robot());
    if (motion == null) {
      return;
    }
    switch (value) {
      case MOVING, IDLE -> {
        // Nothing to check.
      }
      case DONE -> done(motion, variable.timeNs(), report);
      case FAIL -> {
        report.checked(TOLD);
        motion.isOpen = false;
      }
    }
  }

  private void done(MotionRecord motion, long nowNs, Report report) {
    motion.isOpen = false;
    report.checked(TOLD);
    if (!bodies.isOnFloor(motion.robot)) {
      report.violated(TOLD, nowNs, List.of(motion.robot), "DONE without a body on the floor");
      return;
    }
    if (isLocated) {
      report.checked(LOCATED);
    }
    Pose truth = bodies.poseAt(motion.robot, nowNs);
    if (!bodies.isNear(motion, nowNs)) {
      String detail = "DONE " + truth.distanceMm(motion.target) + " mm from " + motion.target;
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    }
    if (!(truth.distanceMm(motion.saidAt) <= motion.saidErrorMm + BodyPath.ROUNDING_MM)) {
      String detail =
          "claims to be within " + motion.saidErrorMm + " mm of " + motion.saidAt + ", but is not";
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    }
    if (motion.owesArrives) {
      report.checked(ARRIVES);
      motion.owesArrives = false;
    }
  }

  private void failed(MotionRecord motion, MotionFailure why, long nowNs, Report report) {
    checkPatience(motion, why, nowNs, report);
    checkFixes(motion, why, nowNs, report);
    checkHeldUp(motion, nowNs, report);
    checkBump(motion, why, nowNs, report);
    if (motion.owesArrives && !isExternal(motion, why)) {
      report.checked(ARRIVES);
      String detail = "fails without an obstacle on the way to " + motion.target + ": " + why;
      report.violated(ARRIVES, nowNs, List.of(motion.robot), detail);
    }
    motion.owesArrives = false;
  }

  private void checkLocated(Variable variable, Report report) {
    Deviation deviation = variable.of(Deviation.VAR);
    if (isLocated && deviation != null && (deviation.isFalse() || deviation.isTurned())) {
      String heading = deviation.isTurned() ? ", heading " + deviation.headingRad() : "";
      report.violated(LOCATED, variable.timeNs(), List.of(variable.robot()), deviation + heading);
    }
  }

  /** A motion that is held back must wait, and one that does not move must try, before it fails. */
  private void checkPatience(MotionRecord motion, MotionFailure why, long nowNs, Report report) {
    // Without progress on the way that it drives: on a new one it begins anew.
    long sinceNs = why == MotionFailure.NO_PROGRESS ? motion.triesFromNs : motion.startNs;
    if (waitsStanding(why)) {
      sinceNs = Math.max(sinceNs, bodies.standsFromNs(motion.robot, nowNs));
    }
    long leastMs = patienceMs(why) - p.reactionMs() - CLOCK_MS;
    boolean isEarly =
        nowNs - sinceNs < leastMs * NS_PER_MS
            || (why == MotionFailure.TOO_SLOW && nowNs < motion.slowFromNs - CLOCK_MS * NS_PER_MS);
    if (isEarly && motion.hasTrueClock && !isRealTime) {
      String detail =
          "fails " + (nowNs - sinceNs) / NS_PER_MS + " ms after it began to try: " + why;
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    }
  }

  private void checkFixes(MotionRecord motion, MotionFailure why, long nowNs, Report report) {
    long fixAgeNs = p.maxFixAgeMs() * NS_PER_MS;
    if (isLocated && !fixes.allow(why, motion.robot, fixAgeNs, nowNs)) {
      String detail = "fails, and its fixes have no such fault: " + why;
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    }
  }

  /** A robot reacts to a bump, and does not push on; one whose wheels turn in vain fails. */
  private void checkHeldUp(MotionRecord motion, long nowNs, Report report) {
    long stoodNs = nowNs - Math.max(motion.triesFromNs, bodies.standsFromNs(motion.robot, nowNs));
    // Its wheels may be stuck.
    long mostMs = motion.isCalm ? heldUpMs : heldUpMs + p.stuckAfterMs();
    boolean isTimed = faultsOfTime == 0 && !isRealTime;
    if (motion.isOpen && isTimed && stoodNs > mostMs * NS_PER_MS) {
      String detail = "stands for " + stoodNs / NS_PER_MS + " ms during its move";
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    }
  }

  /** After a bump a motion fails by the policy, and only then; it may have to back off first. */
  private void checkBump(MotionRecord motion, MotionFailure why, long nowNs, Report report) {
    if (why != MotionFailure.BUMPED) {
      return;
    }
    boolean owesRetreat = isBackingOff && motion.isCalm && !motion.hasBackedOff;
    if (!p.collisionPolicy().fails()) {
      String detail = "fails after a bump, and its policy is to go on";
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    } else if (owesRetreat && bodies.mayBackOff(motion, walls, nowNs)) {
      String detail = "fails after a bump, and has not backed off";
      report.violated(TOLD, nowNs, List.of(motion.robot), detail);
    }
  }

  private static boolean waitsStanding(MotionFailure why) {
    return switch (why) {
      case IN_THE_WAY, NO_FIX, CONTRADICTED, UNCERTAIN -> true;
      default -> false;
    };
  }

  private long patienceMs(MotionFailure why) {
    return switch (why) {
      case IN_THE_WAY -> p.avoidPatienceMs();
      case NO_PROGRESS -> p.stuckAfterMs();
      // The age of the last good fix counts; the wheels stop a step after it is too old.
      case NO_FIX, CONTRADICTED -> p.failFixAgeMs() - p.maxFixAgeMs() - p.automatonPeriodMs();
      case UNCERTAIN -> p.failFixAgeMs() - p.automatonPeriodMs();
      case TARGET_FORBIDDEN, NO_WAY, BUMPED, TOO_SLOW -> 0;
    };
  }

  /**
   * Whether the cause is outside the motion: the body touched something, the robot knows obstacles,
   * or its position is unknown.
   */
  private boolean isExternal(MotionRecord motion, MotionFailure why) {
    return switch (why) {
      case BUMPED, NO_WAY, NO_FIX, CONTRADICTED, UNCERTAIN -> true;
      case NO_PROGRESS, TOO_SLOW, IN_THE_WAY -> !p.collisionPolicy().fails() || motion.hasBackedOff;
      case TARGET_FORBIDDEN -> false;
    };
  }

  private void failing(Fault fault) {
    isRealTime |= fault.isRealTime();
    fixes.observe(fault);
    for (MotionRecord motion : bodies.motions().values()) {
      firstDeadlineNs = Math.min(firstDeadlineNs, deadlineNs(motion));
    }
    switch (fault.name()) {
      case Fault.BEGIN -> {
        faults++;
        if (isOfTime(fault)) {
          faultsOfTime++;
          bodies.motions().values().forEach(motion -> motion.hasTrueClock = false);
        }
        for (MotionRecord motion : bodies.motions().values()) {
          motion.owesArrives = false;
          motion.isCalm = false;
        }
      }
      case Fault.END -> {
        faults--;
        if (isOfTime(fault)) {
          faultsOfTime--;
          bodies.motions().values().forEach(motion -> extendDeadline(motion, fault.timeNs()));
        }
      }
      default -> {}
    }
  }

  /** Whether the fault affects clocks or computing time, on which the bounds depend. */
  private static boolean isOfTime(Fault fault) {
    return TIME_FAULTS.contains(fault.effect());
  }

  /** After a fault of time the motion has its whole bound again. */
  private void extendDeadline(MotionRecord motion, long nowNs) {
    motion.deadlineNs += nowNs - motion.startNs;
    firstDeadlineNs = Math.min(firstDeadlineNs, motion.deadlineNs);
  }

  private static void followed(MotionRecord motion, @Nullable Moved moved, Report report) {
    report.checked(AVOIDS);
    if (moved != null) {
      String detail = "enters " + motion.avoid;
      report.violated(AVOIDS, moved.timeNs(), List.of(motion.robot), detail);
    }
  }

  private void checkDeadlines(long nowNs, Report report) {
    if (nowNs <= firstDeadlineNs || faultsOfTime > 0) {
      return;
    }
    firstDeadlineNs = NEVER;
    for (MotionRecord motion : bodies.motions().values()) {
      long deadlineNs = deadlineNs(motion);
      if (motion.isOpen && nowNs > deadlineNs) {
        motion.isOpen = false;
        report.checked(TOLD);
        String detail =
            "reports no result for " + motion.target + " since " + motion.startNs + " ns";
        report.overdue(TOLD, deadlineNs, List.of(motion.robot), detail);
      } else if (motion.isOpen) {
        firstDeadlineNs = Math.min(firstDeadlineNs, deadlineNs);
      }
    }
  }
}

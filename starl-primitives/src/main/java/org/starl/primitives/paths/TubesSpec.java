package org.starl.primitives.paths;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.InstanceMonitor;
import org.starl.spec.Monitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of every {@link DistributedPathPlanning} in a run.
 *
 * <ul>
 *   <li>{@code Tubes}: tubes held by two robots in one instance do not meet, and none meets the body
 *       of a robot that holds no tube yet. A crashed robot keeps its tubes.
 *   <li>{@code Inside}: the true body of a robot that holds tubes lies wholly in one part of a
 *       tube. Checked every 10 ms of movement.
 *   <li>{@code Freed}: a robot frees a part only when its body is certainly in the rest: by its own
 *       position and error bound.
 *   <li>{@code Told}: every {@code goTo} is DONE or FAIL within the bound, unless its robot
 *       crashes, and what it was told stays so. A robot drives in its tube only.
 *   <li>{@code Passed}: a robot that drives, or has driven, soon holds no more than it needs: one tube,
 *       with its body in the first part; when it has arrived, the disc at the end.
 * </ul>
 */
public final class TubesSpec extends InstanceMonitor<SortedMap<RobotId, List<Tube>>> {

  static final String TUBES = "tubes.Tubes";
  static final String INSIDE = "tubes.Inside";
  static final String FREED = "tubes.Freed";
  static final String TOLD = "tubes.Told";
  static final String PASSED = "tubes.Passed";

  private static final long STEP_NS = 10_000_000;

  /** The time within which a robot stands after its drive. */
  private static final long STOP_NS = 1_000_000_000;

  /** The time within which a robot gives back what it has passed, when no fault is active. */
  private static final long PASSED_NS = 3_000_000_000L;

  /** Rounding of positions in closed form. */
  private static final double ROUNDING_MM = 1e-3;

  private final Bodies bodies = new Bodies();
  private final FaultState faults = new FaultState();
  private final Set<ProcessKey> outside = new LinkedHashSet<>();
  private final Deadlines tasks;
  private final Deadlines passed;
  private final Map<ProcessKey, TubeFlag> flags = new LinkedHashMap<>();
  // Those that have driven since their latest start: before, a robot may hold what a crash has
  // left.
  private final Set<ProcessKey> driven = new LinkedHashSet<>();
  private final SortedMap<RobotId, Long> standsFromNs = new TreeMap<>();
  private long nextCheckNs;

  /** Safety only. */
  public TubesSpec() {
    this(Deadlines.NO_BOUND);
  }

  /**
   * Safety, and progress within a bound.
   *
   * @param boundNs the settings' deadline plus the longest drive
   */
  public TubesSpec(long boundNs) {
    super(TubeFact.PRIMITIVE);
    lemma(TUBES, "No two robots hold tubes that meet.");
    lemma(INSIDE, "A robot's body lies wholly within a tube that it holds.");
    lemma(
        FREED,
        "A robot frees a part of its tube only when its whole body is in the rest, within its error bound.");
    tasks =
        new Deadlines(
            TOLD, boundNs, sinceNs -> "goTo at " + sinceNs + " ns is neither done nor failed");
    passed =
        new Deadlines(
            PASSED,
            tasks.isBounded() ? PASSED_NS : Deadlines.NO_BOUND,
            sinceNs -> "holds more than it needs, since " + sinceNs + " ns");
    if (tasks.isBounded()) {
      progress(
          TOLD, "Every drive ends, done or failed, within the bound, and then the robot stands.");
      progress(PASSED, "A robot gives back the tubes that it does not need, and passed parts.");
    }
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new TubeConsentSpec());
  }

  @Override
  protected SortedMap<RobotId, List<Tube>> begin(Instance source) {
    return new TreeMap<>();
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    tasks.expire(event.timeNs(), report);
    checkInsideUntil(event.timeNs(), report);
    passed.expire(event.timeNs(), report);
    if (faults.observe(event)) {
      passed.assumeAll(faults.isFaultFree(), event.timeNs());
    }
    if (event instanceof TraceEvent.Moved moved) {
      checkStands(moved, report);
    }
    bodies.observe(event);
    super.observe(event, report);
  }

  @Override
  protected void acted(Action action, Report report) {
    switch (action.fact()) {
      case TubeFact.goTo f ->
          tasks.start(new ProcessKey(action.source(), action.robot()), action.timeNs());
      case TubeFact.frees f -> checkFreed(action, f, report);
      default -> {}
    }
  }

  /** Before the error is as large as its bound, and the body outside: that is rare. */
  private void checkFreed(Action action, TubeFact.frees f, Report report) {
    report.checked(FREED);
    double radiusMm = bodies.radiusMm(action.robot()) + f.errorMm() - ROUNDING_MM;
    Point at = new Point(f.xMm(), f.yMm());
    if (f.rest().tubes().stream().noneMatch(rest -> rest.containsDisc(at, radiusMm))) {
      String detail =
          "frees all but "
              + f.rest()
              + ", and may be up to "
              + Math.round(f.errorMm())
              + " mm from ("
              + Math.round(at.xMm())
              + ", "
              + Math.round(at.yMm())
              + ") mm";
      report.violated(FREED, action.timeNs(), List.of(action.robot()), detail);
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      instances().keySet().forEach(source -> crashed(new ProcessKey(source, fault.robot())));
    } else if (event instanceof TraceEvent.Moved moved) {
      checkInsideAt(moved.timeNs(), report);
    }
  }

  private void crashed(ProcessKey key) {
    tasks.stop(key);
    passed.stop(key);
    flags.remove(key);
    driven.remove(key);
  }

  @Override
  public void finish(long endNs, Report report) {
    tasks.expire(endNs, report);
    checkInsideUntil(endNs, report);
    passed.expire(endNs, report);
    checkInsideAt(endNs, report);
  }

  @Override
  protected void changed(Variable variable, Report report) {
    RobotId robot = variable.robot();
    TubeList held = variable.of(TubeFact.HELD);
    if (held != null) {
      SortedMap<RobotId, List<Tube>> all = instance(variable.source());
      all.put(robot, held.tubes());
      checkTubes(variable, all, report);
      checkInsideAt(variable.timeNs(), report);
    }
    ProcessKey key = new ProcessKey(variable.source(), robot);
    TubeFailure why = variable.of(TubeFact.FAILURE);
    if (why != null && why != TubeFailure.NONE && isOver(flags.get(key)) && tasks.isBounded()) {
      String detail = "fails by " + why + ", although no drive is under way";
      report.violated(TOLD, variable.timeNs(), List.of(robot), detail);
    }
    TubeFlag flag = variable.of(TubeFact.FLAG);
    if (flag != null) {
      flags.put(key, flag);
      if (flag == TubeFlag.MOVING) {
        driven.add(key);
        standsFromNs.remove(robot);
      } else {
        standsFromNs.putIfAbsent(robot, variable.timeNs() + STOP_NS);
      }
      if (isOver(flag)) {
        tasks.meet(key, report);
      }
      checkInsideAt(variable.timeNs(), report);
    }
  }

  private static boolean isOver(@Nullable TubeFlag flag) {
    return flag == TubeFlag.DONE || flag == TubeFlag.FAIL;
  }

  private void checkStands(TraceEvent.Moved moved, Report report) {
    Long fromNs = standsFromNs.get(moved.robot());
    boolean drives = bodies.isOnFloor(moved.robot()) && bodies.isMoving(moved.robot());
    if (drives && fromNs != null && moved.timeNs() > fromNs && tasks.isBounded()) {
      standsFromNs.remove(moved.robot());
      String detail = "drives, although no drive is under way";
      report.violated(TOLD, moved.timeNs(), List.of(moved.robot()), detail);
    }
  }

  private void checkTubes(Variable variable, SortedMap<RobotId, List<Tube>> all, Report report) {
    report.checked(TUBES);
    List<Tube> mine = all.getOrDefault(variable.robot(), List.of());
    for (Map.Entry<RobotId, List<Tube>> other : all.entrySet()) {
      RobotId robot = other.getKey();
      List<Tube> theirs = other.getValue();
      if (!robot.equals(variable.robot()) && Tube.meet(mine, theirs)) {
        violatesTubes(variable, robot, "holds " + Tube.text(theirs), report);
      } else if (theirs.isEmpty() && meetsBody(mine, robot, variable.timeNs())) {
        violatesTubes(variable, robot, "stands there, and holds no tube yet", report);
      }
    }
  }

  private static void violatesTubes(Variable held, RobotId other, String what, Report report) {
    report.violated(
        TUBES,
        held.timeNs(),
        List.copyOf(new TreeSet<>(List.of(held.robot(), other))),
        String.format("tubes meet: %s holds %s, %s %s", held.robot(), held.value(), other, what));
  }

  private boolean meetsBody(List<Tube> tubes, RobotId robot, long nowNs) {
    if (!bodies.isOnFloor(robot)) {
      return false;
    }
    Point at = bodies.poseAt(robot, nowNs).at();
    double radiusMm = bodies.radiusMm(robot);
    return tubes.stream()
        .flatMap(tube -> tube.capsules().stream())
        .anyMatch(part -> part.axis().distanceMm(at) < part.radiusMm() + radiusMm);
  }

  private void checkInsideUntil(long timeNs, Report report) {
    while (nextCheckNs <= timeNs) {
      if (!bodies.isAnyMoving()) {
        nextCheckNs = timeNs + 1;
        return;
      }
      checkInsideAt(nextCheckNs, report);
      nextCheckNs += STEP_NS;
    }
  }

  private void checkInsideAt(long timeNs, Report report) {
    instances()
        .forEach((source, held) ->
            held.forEach((robot, tubes) -> {
              if (!tubes.isEmpty() && bodies.isOnFloor(robot)) {
                checkInside(source, robot, tubes, timeNs, report);
              }
            }));
  }

  private void checkInside(
      Instance source, RobotId robot, List<Tube> tubes, long timeNs, Report report) {
    report.checked(INSIDE);
    Point at = bodies.poseAt(robot, timeNs).at();
    double radiusMm = bodies.radiusMm(robot) - ROUNDING_MM;
    ProcessKey key = new ProcessKey(source, robot);
    if (driven.contains(key)) {
      checkPassed(key, tubes, at, radiusMm, timeNs, report);
    }
    if (tubes.stream().anyMatch(tube -> tube.containsDisc(at, radiusMm))) {
      outside.remove(key);
    } else if (outside.add(key)) {
      report.violated(
          INSIDE,
          timeNs,
          List.of(robot),
          "its body around ("
              + Math.round(at.xMm())
              + ", "
              + Math.round(at.yMm())
              + ") mm is not inside its tubes: "
              + Tube.text(tubes));
    }
  }

  private void checkPassed(
      ProcessKey key, List<Tube> tubes, Point at, double radiusMm, long timeNs, Report report) {
    TubeFlag flag = flags.get(key);
    Tube tube = tubes.get(0);
    boolean needsIt =
        flag == TubeFlag.DONE ? tube.points().size() == 1 : tube.part(0).containsDisc(at, radiusMm);
    if ((flag != TubeFlag.MOVING && !isOver(flag)) || (tubes.size() == 1 && needsIt)) {
      passed.stop(key);
    } else {
      passed.start(key, timeNs);
    }
    if (passed.isBounded()) {
      report.checked(PASSED);
    }
  }
}

package org.starl.apps.fleet.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.FleetFact;
import org.starl.apps.fleet.logic.FleetFact.Work;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.Roads;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.id.RobotId;
import org.starl.primitives.ledger.LedgerEntry;
import org.starl.primitives.ledger.LedgerFact;
import org.starl.primitives.ledger.LedgerOutcome;
import org.starl.primitives.mutex.HeldSections;
import org.starl.primitives.mutex.MutexFact;
import org.starl.spec.Bodies;
import org.starl.spec.FaultState;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of a fleet.
 *
 * <ul>
 *   <li>{@code fleet.apart}: no two true bodies touch; so no two are at one vertex. Checked every 40 ms of
 *       movement, 10 mm of way.
 *   <li>{@code fleet.on_lane}: the middle of each true body that drives is within 50 mm of its lane: what
 *       the sections assume.
 *   <li>{@code fleet.one_way}: no two robots with their true bodies on a lane drive along it in opposite
 *       directions.
 *   <li>{@code fleet.group}: no two true bodies are on lanes of one group: farther than {@link #END_MM} from
 *       their ends, or at an end of the group that is no parking place or charger.
 *   <li>{@code fleet.held}: a robot holds each section in whose star the middle of its true body is, the
 *       section of the group that it is in, and the station or charger where it stands: why the three above hold. Checked when a robot gives sections up, and each 400 ms of movement.
 *   <li>{@code fleet.begun}: a robot takes a load aboard only when the ledger has told it that it has begun
 *       this delivery.
 *   <li>{@code fleet.once}: each delivery is put down once.
 *   <li>{@code fleet.charged}: no battery is empty. Its charge rises while the robot charges only, also over a
 *       restart, and it is full when the robot leaves the charger.
 *   <li>{@code fleet.none_lost}: at the end each delivery has been put down.
 *   <li>{@code fleet.in_time}: each is put down within the bound after it was asked for; the time begins
 *       again when faults have ended.
 * </ul>
 */
public final class FleetSpec extends LemmaMonitor {

  public static final String APART = "fleet.apart";
  static final String ON_LANE = "fleet.on_lane";
  static final String ONE_WAY = "fleet.one_way";
  static final String GROUP = "fleet.group";
  static final String HELD = "fleet.held";
  static final String BEGUN = "fleet.begun";
  static final String ONCE = "fleet.once";
  static final String CHARGED = "fleet.charged";
  static final String NONE_LOST = "fleet.none_lost";
  static final String IN_TIME = "fleet.in_time";

  private static final long STEP_NS = 40 * Time.NS_PER_MS;

  private static final int HELD_STEPS = 10;

  private static final double LANE_MM = 50;

  // A robot that waits before a lane, or has passed it, may be so near to the lane's end.
  private static final double END_MM = 165;

  // What storage may not have had before a crash.
  private static final int UNSTORED_PERCENT = 5;
  private static final int FULL_PERCENT = 99;

  // Solid bodies never overlap. They may touch from a gap of a millimetre on.
  private static final double TOUCHING_MM = 2;

  private final Roads roads;
  private final NavGraph graph;
  private final List<Delivery> deliveries;
  private final Bodies bodies = new Bodies();
  private final FaultState faults = new FaultState();
  private final Within<Long> open;
  private final SortedSet<String> reported = new TreeSet<>();
  private final SortedMap<RobotId, List<Integer>> lanes = new TreeMap<>();
  private final SortedMap<RobotId, List<Integer>> lastLanes =
      new TreeMap<>(); // also of stopped ones
  private final Map<List<Integer>, SortedSet<String>> groups =
      new LinkedHashMap<>(); // of lanes, in both directions
  private final SortedMap<RobotId, Integer> charges = new TreeMap<>();
  private final SortedMap<RobotId, Work> works = new TreeMap<>();
  private final HeldSections held = new HeldSections();
  private final SortedMap<RobotId, Long> begun = new TreeMap<>();
  private final SortedMap<Long, RobotId> delivered = new TreeMap<>();
  private int asked;
  private long nextCheckNs;
  private long nextHeldNs;

  private record Body(RobotId robot, Point at, double radiusMm) {}

  /**
   * @param deliveries in the order of their times
   * @param boundNs within which each is done, all others included
   */
  public FleetSpec(Roads roads, List<Delivery> deliveries, long boundNs) {
    this.roads = roads;
    graph = roads.graph();
    this.deliveries = List.copyOf(deliveries);
    open = new Within<>(boundNs);
    graph.lanes().forEach(lane -> groups.put(List.of(lane.from(), lane.to()), graph.groups(lane)));
    graph
        .lanes()
        .forEach(lane -> groups.putIfAbsent(List.of(lane.to(), lane.from()), graph.groups(lane)));
    lemma(APART, "No two robots touch.");
    lemma(ON_LANE, "The middle of a robot that drives is on its lane, 50 mm at most beside it.");
    lemma(ONE_WAY, "No two robots on one lane drive in opposite directions.");
    lemma(GROUP, "No two robots are on lanes of one group.");
    lemma(HELD, "A robot holds each section that its middle is in.");
    lemma(BEGUN, "A robot takes a load aboard only when it has begun this delivery.");
    lemma(ONCE, "Each delivery is put down at most once.");
    lemma(CHARGED, "No battery is empty; it is charged at a charger only, until it is full.");
    lemma(NONE_LOST, "At the end of the run each delivery has been put down.");
    progress(IN_TIME, "Each delivery is put down within the bound after it was asked for.");
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    advance(event.timeNs(), report);
    bodies.observe(event);
    if (event instanceof Moved moved && moved.linearMmPerS() == 0) {
      checkApart(event.timeNs(), report); // perhaps a bump has stopped it
    }
    if (faults.observe(event)) {
      open.assumeAll(faults.isFaultFree(), event.timeNs());
    }
    if (event instanceof Variable variable) {
      changed(variable, report);
    }
    if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      works.remove(fault.robot());
    }
    held.observe(event);
    if (event instanceof Action action
        && action.fact() instanceof LedgerFact.Told told
        && told.entry() instanceof LedgerEntry.Begin begin
        && told.outcome() == LedgerOutcome.DONE) {
      begun.put(action.robot(), begin.task().number());
    }
    if (event instanceof Action action
        && (action.fact() instanceof MutexFact.StandsIn
            || action.fact() instanceof MutexFact.Release)) {
      checkHeld(action.robot(), action.timeNs(), report);
    }
  }

  private void changed(Variable variable, Report report) {
    RobotId robot = variable.robot();
    Long number = variable.of(FleetFact.DELIVERED);
    if (number != null && number > 0) {
      RobotId before = delivered.putIfAbsent(number, robot);
      report.checked(ONCE);
      if (before != null) {
        String detail = "delivery " + number + ", after " + before;
        report.violated(ONCE, variable.timeNs(), List.of(robot), detail);
      }
      open.stop(number);
      report.checked(IN_TIME);
    }
    Long load = variable.of(FleetFact.ABOARD);
    if (load != null && load > 0) {
      report.checked(BEGUN);
      if (!load.equals(begun.get(robot))) {
        String detail = "takes delivery " + load + " aboard, and has begun " + begun.get(robot);
        report.violated(BEGUN, variable.timeNs(), List.of(robot), detail);
      }
    }
    charged(variable, report);
    List<Integer> lane = variable.of(FleetFact.LANE);
    if (lane != null) {
      lanes.put(robot, lane);
      if (!lane.isEmpty()) {
        lastLanes.put(robot, lane);
      }
      checkOneWay(robot, lane, variable.timeNs(), report);
    }
  }

  private void charged(Variable variable, Report report) {
    RobotId robot = variable.robot();
    Integer charge = variable.of(FleetFact.CHARGE);
    Work work = variable.of(FleetFact.WORK);
    String problem = "";
    if (charge != null) {
      report.checked(CHARGED);
      int before = Objects.requireNonNullElse(charges.put(robot, charge), charge);
      boolean isFilled = charge > before + UNSTORED_PERCENT && works.get(robot) != Work.CHARGES;
      problem = charge == 0 ? "0 %" : isFilled ? before + " % become " + charge + " %" : "";
    } else if (work != null) {
      int left = charges.getOrDefault(robot, FULL_PERCENT);
      boolean isLeft = works.put(robot, work) == Work.CHARGES && work != Work.CHARGES;
      problem = isLeft && left < FULL_PERCENT ? "leaves the charger with " + left + " %" : "";
    }
    if (!problem.isEmpty()) {
      report.violated(CHARGED, variable.timeNs(), List.of(robot), problem);
    }
  }

  private void checkOneWay(RobotId robot, List<Integer> lane, long timeNs, Report report) {
    report.checked(ONE_WAY);
    if (lane.isEmpty()) {
      return;
    }
    List<Integer> opposite = List.of(lane.get(1), lane.get(0));
    lanes.forEach((other, its) -> {
      if (its.equals(opposite) && isOn(robot, lane, timeNs) && isOn(other, lane, timeNs)) {
        String detail = "both between " + name(lane.get(0)) + " and " + name(lane.get(1));
        report.violated(ONE_WAY, timeNs, List.copyOf(new TreeSet<>(List.of(robot, other))), detail);
      }
    });
  }

  private boolean isOn(RobotId robot, List<Integer> lane, long timeNs) {
    if (!bodies.isOnFloor(robot)) {
      return false;
    }
    Segment segment =
        new Segment(graph.vertices().get(lane.get(0)).at(), graph.vertices().get(lane.get(1)).at());
    double mm = segment.distanceMm(bodies.poseAt(robot, timeNs).at());
    return mm < bodies.radiusMm(robot);
  }

  private Segment segment(List<Integer> lane) {
    return new Segment(
        graph.vertices().get(lane.get(0)).at(), graph.vertices().get(lane.get(1)).at());
  }

  private String name(int vertex) {
    return graph.vertices().get(vertex).name();
  }

  @Override
  public void finish(long endNs, Report report) {
    advance(endNs, report);
    report.checked(NONE_LOST);
    if (delivered.size() < deliveries.size()) {
      int lost = deliveries.size() - delivered.size();
      report.violated(
          NONE_LOST, endNs, List.of(), lost + " of " + deliveries.size() + " are not put down");
    }
  }

  private void advance(long timeNs, Report report) {
    while (asked < deliveries.size() && deliveries.get(asked).atNs() <= timeNs) {
      open.start((long) asked + 1, deliveries.get(asked).atNs());
      asked++;
    }
    open.expire(
        timeNs,
        (number, sinceNs, deadlineNs) -> {
          report.checked(IN_TIME);
          report.violated(IN_TIME, deadlineNs, List.of(), "delivery " + number);
        });
    while (nextCheckNs <= timeNs) {
      if (bodies.isAnyMoving()) {
        checkApart(nextCheckNs, report);
        checkOnLane(report);
        checkGroups(report);
        if (nextCheckNs >= nextHeldNs) {
          nextHeldNs = nextCheckNs + HELD_STEPS * STEP_NS;
          bodies.robots().forEach(robot -> checkHeld(robot, nextCheckNs, report));
        }
        nextCheckNs += STEP_NS;
      } else {
        nextCheckNs = timeNs + STEP_NS - timeNs % STEP_NS;
      }
    }
  }

  private void checkOnLane(Report report) {
    report.checked(ON_LANE);
    lanes.forEach((robot, lane) -> {
      if (!lane.isEmpty() && bodies.isOnFloor(robot) && bodies.isMoving(robot)) {
        double mm = segment(lane).distanceMm(bodies.poseAt(robot, nextCheckNs).at());
        String key = robot + " beside";
        if (mm <= LANE_MM) {
          reported.remove(key);
        } else if (reported.add(key)) {
          String detail = Math.round(mm) + " mm beside the lane to " + name(lane.get(1));
          report.violated(ON_LANE, nextCheckNs, List.of(robot), detail);
        }
      }
    });
  }

  private void checkGroups(Report report) {
    report.checked(GROUP);
    SortedMap<String, RobotId> inside = new TreeMap<>();
    lastLanes.forEach((robot, lane) -> {
      for (String group : groups.getOrDefault(lane, Collections.emptySortedSet())) {
        if (bodies.isOnFloor(robot) && isIn(group, lane, bodies.poseAt(robot, nextCheckNs).at())) {
          RobotId other = inside.putIfAbsent(group, robot);
          if (other != null && reported.add(group + other + robot)) {
            report.violated(GROUP, nextCheckNs, List.of(other, robot), "both in " + group);
          }
        }
      }
    });
  }

  private void checkHeld(RobotId robot, long timeNs, Report report) {
    if (!bodies.isOnFloor(robot)) {
      return;
    }
    report.checked(HELD);
    Point at = bodies.poseAt(robot, timeNs).at();
    Set<String> missing = roads.around(at);
    List<Integer> lane = lastLanes.getOrDefault(robot, List.of());
    groups.getOrDefault(lane, Collections.emptySortedSet()).stream()
        .filter(group -> isIn(group, lane, at))
        .forEach(group -> missing.add(roads.section(group)));
    missing.removeIf(section -> held.holds(robot, section));
    String key = robot + " without";
    if (missing.isEmpty()) {
      reported.remove(key);
    } else if (reported.add(key)) {
      String detail = "is in " + missing + " and holds " + held.held(robot);
      report.violated(HELD, timeNs, List.of(robot), detail);
    }
  }

  private boolean isIn(String group, List<Integer> lane, Point at) {
    return segment(lane).distanceMm(at) <= LANE_MM
        && lane.stream()
            .allMatch(
                end -> at.distanceMm(graph.vertices().get(end).at()) > END_MM || isOf(group, end));
  }

  private boolean isOf(String group, int vertex) {
    NavGraph.Vertex its = graph.vertices().get(vertex);
    return its.group().equals(group) && (its.isStation() || !(its.isParking() || its.isCharger()));
  }

  private void checkApart(long timeNs, Report report) {
    report.checked(APART);
    List<Body> all = new ArrayList<>();
    bodies.forEach(
        timeNs, (robot, pose, radiusMm, isMoving) -> all.add(new Body(robot, pose.at(), radiusMm)));
    double widestMm = all.stream().mapToDouble(Body::radiusMm).max().orElse(0);
    all.sort(Comparator.comparingDouble(body -> body.at().xMm()));
    for (int i = 0; i < all.size(); i++) {
      Body one = all.get(i);
      double farthestMm = one.at().xMm() + one.radiusMm() + widestMm + TOUCHING_MM;
      for (int j = i + 1; j < all.size() && all.get(j).at().xMm() < farthestMm; j++) {
        checkApart(one, all.get(j), timeNs, report);
      }
    }
  }

  private void checkApart(Body one, Body other, long timeNs, Report report) {
    double gapMm = one.at().distanceMm(other.at()) - one.radiusMm() - other.radiusMm();
    List<RobotId> robots = List.copyOf(new TreeSet<>(List.of(one.robot(), other.robot())));
    if (gapMm > TOUCHING_MM) {
      reported.remove(robots.toString());
    } else if (reported.add(robots.toString())) {
      String detail =
          String.format(Locale.ROOT, "touch around %.0f, %.0f mm", one.at().xMm(), one.at().yMm());
      report.violated(APART, timeNs, robots, detail);
    }
  }
}

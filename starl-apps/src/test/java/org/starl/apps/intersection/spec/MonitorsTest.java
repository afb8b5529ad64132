package org.starl.apps.intersection.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.registration.RegistrationAction;
import org.starl.shape.Shapes;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** Each monitor reports a violation exactly where its lemma does not hold. */
class MonitorsTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");
  private static final long SECOND_NS = 1_000_000_000;
  private static final Instance MUTEX = Instance.of("mutex", "crossing");
  private static final Instance QUEUE = Instance.of("mutex", "crossing.queue1");

  private final List<TraceEvent> events = new ArrayList<>();
  private long nowNs;

  private void after(double seconds) {
    nowNs += (long) (seconds * SECOND_NS);
  }

  private static ProcessId process(RobotId robot) {
    return ProcessId.first(robot, 1);
  }

  private static SortedSet<String> zones(String... names) {
    return Sections.copyOf(List.of(names));
  }

  private void mutex(Instance mutex, RobotId robot, MutexFact fact) {
    events.add(Action.of(nowNs, robot, mutex, MutexFact.SHAPE, fact));
  }

  private void asks(RobotId robot, String... want) {
    ProcessId who = process(robot);
    SortedSet<ProcessId> known = new TreeSet<>(List.of(who));
    mutex(MUTEX, robot, new MutexFact.DoMutex(who, 1, 5, zones(want), known));
  }

  private void holds(RobotId robot, String... held) {
    mutex(MUTEX, robot, new MutexFact.OdMutex(process(robot), 1, zones(held)));
  }

  private void releases(RobotId robot, SortedSet<String> given, SortedSet<String> left) {
    mutex(MUTEX, robot, new MutexFact.Release(process(robot), 1, given, left));
  }

  private void app(RobotId robot, Location location) {
    events.add(
        new TraceEvent.Variable(nowNs, robot, Instance.APP, CrossingFact.LOCATION, location));
  }

  private void ahead(RobotId robot, String... zones) {
    events.add(
        new TraceEvent.Variable(nowNs, robot, Instance.APP, CrossingFact.MYSEQ, List.of(zones)));
  }

  private void joins(RobotId robot, double xMm, double yMm) {
    events.add(new TraceEvent.Joined(nowNs, robot, Pose.of(new Point(xMm, yMm), 0), 165));
  }

  private void drives(RobotId robot, double xMm, double yMm, double mmPerS) {
    events.add(new TraceEvent.Moved(nowNs, robot, Pose.of(new Point(xMm, yMm), 0), mmPerS, 0));
  }

  private SpecReport report(Monitor monitor) {
    Monitors monitors = new Monitors(List.of(monitor));
    events.forEach(monitors::observe);
    monitors.finish(nowNs);
    monitor
        .lemmas()
        .forEach(lemma -> assertThat(monitors.report().checks(lemma)).as(lemma).isPositive());
    return monitors.report();
  }

  private static void assertRed(SpecReport report, String lemma, double atS, RobotId... robots) {
    assertThat(report.violations(lemma)).as("%s", report).isPositive();
    Violation first =
        report.violations().stream().filter(v -> v.lemma().equals(lemma)).findFirst().orElseThrow();
    assertThat(first.robots()).containsExactlyInAnyOrder(robots);
    assertThat(first.timeNs() / (double) SECOND_NS).isBetween(atS - 0.01, atS + 0.02);
  }

  private void fails(RobotId robot, long num, MutexFailure why) {
    mutex(MUTEX, robot, new MutexFact.Withdraw(process(robot), num, why));
  }

  @Test
  void aCarThatAsksAgainWithoutRegisteringViolatesRegisters() {
    sets(BOT0, "A");
    fails(BOT0, 1, MutexFailure.FENCED);
    events.add(
        Action.of(
            nowNs,
            BOT0,
            Instance.of("registration", "crossing"),
            Shapes.of(
                    RegistrationAction.do_register.class,
                    Shapes.part("i", Shapes.PROCESS, RegistrationAction.do_register::i),
                    RegistrationAction.do_register::new)
                .named("do_register"),
            new RegistrationAction.do_register(process(BOT0))));
    after(1);
    fails(BOT0, 0, MutexFailure.NOT_REGISTERED);
    after(1);
    fails(BOT0, 0, MutexFailure.NOT_REGISTERED);
    SpecReport report = report(new ListCrit("crossing"));
    assertRed(report, ListCrit.REGISTERS, 2, BOT0);
    assertThat(report.violations(ListCrit.REGISTERS)).isEqualTo(1);
  }

  private static TrafficSafety trafficSafety() {
    return new TrafficSafety(Crossing.regions(0));
  }

  @Test
  void oneCarAfterTheOtherIsSafe() {
    joins(BOT0, 1700, 2250);
    holds(BOT0, "C", "D", "D1");
    drives(BOT0, 1700, 2250, 250);
    after(7.4);
    drives(BOT0, 3550, 2250, 0);
    releases(BOT0, zones("C", "D"), zones("D1"));
    joins(BOT1, 1700, 2250);
    holds(BOT1, "C");
    drives(BOT1, 1700, 2250, 250);
    after(2);
    drives(BOT1, 2200, 2250, 0);
    after(1);
    assertThat(report(trafficSafety()).holds()).isTrue();
  }

  @Test
  void twoBodiesInOneZoneAreReportedDuringMotion() {
    joins(BOT0, 2250, 2250);
    holds(BOT0, "C");
    joins(BOT1, 1600, 2250);
    drives(BOT1, 1600, 2250, 250);
    after(5);
    SpecReport report = report(trafficSafety());
    // Its front crosses the border at x = 2000 after 235 mm.
    assertRed(report, "intersection.traffic_safety", 0.94, BOT0, BOT1);
    assertRed(report, "intersection.occupied_is_held", 0.94, BOT1);
  }

  @Test
  void aZoneReleasedTooEarlyIsReportedEvenIfNoOtherCarEnters() {
    joins(BOT0, 2250, 2250);
    holds(BOT0, "C", "D1");
    after(1);
    releases(BOT0, zones("C"), zones("D1"));
    after(1);
    SpecReport report = report(trafficSafety());
    assertThat(report.violations("intersection.traffic_safety")).isZero();
    assertRed(report, "intersection.occupied_is_held", 1, BOT0);
  }

  @Test
  void aCarThatIsCarriedIntoAZoneAndStandsThereIsReported() {
    joins(BOT0, 500, 500);
    holds(BOT0, "A");
    after(1);
    drives(BOT0, 2250, 2250, 0);
    after(1);
    assertRed(report(trafficSafety()), "intersection.occupied_is_held", 1, BOT0);
  }

  @Test
  void aCarThatHasLeftTheFloorOccupiesNoZone() {
    joins(BOT0, 2250, 2250);
    holds(BOT0, "C");
    after(1);
    events.add(new TraceEvent.Left(nowNs, BOT0));
    after(1);
    joins(BOT1, 2250, 2250);
    holds(BOT1, "C");
    assertThat(report(trafficSafety()).violations("intersection.traffic_safety")).isZero();
  }

  @Test
  void aPlaceIsHeldThroughTheMutexOfItsRank() {
    joins(BOT0, 1100, 2250);
    mutex(QUEUE, BOT0, new MutexFact.OdMutex(process(BOT0), 1, zones("C0.1")));
    after(1);
    holds(BOT0, "C", "C1");
    releases(BOT0, zones("C", "C1"), zones());
    after(1);
    assertThat(report(new TrafficSafety(Crossing.regions(Crossing.CLAIMED_PLACES))).holds())
        .isTrue();
    mutex(QUEUE, BOT0, new MutexFact.Release(process(BOT0), 1, zones("C0.1"), zones()));
    after(1);
    SpecReport report = report(new TrafficSafety(Crossing.regions(Crossing.CLAIMED_PLACES)));
    assertRed(report, "intersection.occupied_is_held", 2, BOT0);
  }

  @Test
  void disjointCritSetsAreSafe() {
    holds(BOT0, "A", "A1");
    holds(BOT1, "B", "B1", "D");
    releases(BOT1, zones("D"), zones("B", "B1"));
    assertThat(report(trafficSafety()).holds()).isTrue();
  }

  @Test
  void overlappingCritSetsAreReported() {
    holds(BOT0, "A", "C", "C1");
    after(1);
    releases(BOT0, zones("A"), zones("C", "C1"));
    after(1);
    holds(BOT1, "B", "C");
    assertRed(report(trafficSafety()), "intersection.Inv_mux_safety", 2, BOT0, BOT1);
  }

  private void sets(RobotId robot, String... trip) {
    Way way = new Way("route", Optional.empty(), List.of(trip));
    events.add(Action.of(nowNs, robot, Instance.APP, Way.SHAPE, way));
  }

  private void asksForAAndA1() {
    sets(BOT0, "A", "A1");
    app(BOT0, Location.S_0);
    ahead(BOT0, "A", "A1");
    after(1);
    app(BOT0, Location.REGISTER_WAIT);
    after(1);
    asks(BOT0, "A", "A1");
    app(BOT0, Location.MUTEX_WAIT);
    after(1);
  }

  private static ListCrit listCrit() {
    return new ListCrit("crossing");
  }

  @Test
  void aMovingCarMayHoldTheRestOfItsPath() {
    asksForAAndA1();
    holds(BOT0, "A", "A1");
    after(0.1);
    app(BOT0, Location.MOVE_WAIT);
    after(5);
    releases(BOT0, zones("A"), zones("A1"));
    ahead(BOT0, "A1");
    after(5);
    ahead(BOT0);
    app(BOT0, Location.S_1);
    after(1);
    assertThat(report(listCrit()).holds()).isTrue();
  }

  @Test
  void aCarThatMovesWithoutHoldingIsReported() {
    asksForAAndA1();
    app(BOT0, Location.MOVE_WAIT);
    after(1);
    assertRed(report(listCrit()), "intersection.Inv_list_crit", 3, BOT0);
  }

  @Test
  void aCarThatReleasesAZoneAheadIsReported() {
    asksForAAndA1();
    holds(BOT0, "A", "A1");
    app(BOT0, Location.MOVE_WAIT);
    after(1);
    releases(BOT0, zones("A1"), zones("A"));
    after(1);
    assertRed(report(listCrit()), "intersection.Inv_list_crit", 4, BOT0);
  }

  @Test
  void aLostCopyDoesNotPartAReleaseFromTheRestOfItsAction() {
    asksForAAndA1();
    holds(BOT0, "A", "A1");
    after(0.1);
    app(BOT0, Location.MOVE_WAIT);
    after(5);
    releases(BOT0, zones("A"), zones("A1"));
    events.add(new TraceEvent.Dropped(nowNs, BOT1, "bot0", "loss"));
    ahead(BOT0, "A1");
    after(5);
    assertThat(report(listCrit()).holds()).isTrue();
  }

  @Test
  void aCarThatRequestsLessThanItsPathIsReported() {
    sets(BOT0, "A", "A1");
    app(BOT0, Location.S_0);
    ahead(BOT0, "A", "A1");
    after(2);
    asks(BOT0, "A");
    app(BOT0, Location.MUTEX_WAIT);
    after(1);
    assertRed(report(listCrit()), "intersection.Inv_list_crit", 2, BOT0);
  }

  @Test
  void aCarThatDepartsWithinTheBoundMakesProgress() {
    sets(BOT0, "A", "A1");
    joins(BOT0, 0, 0);
    after(20);
    events.add(new TraceEvent.Left(nowNs, BOT0));
    after(1000);
    assertThat(report(new TrafficProgress(80 * SECOND_NS, List.of())).holds()).isTrue();
  }

  @Test
  void aRobotWithoutATripNeedNotDepart() {
    joins(BOT1, 1000, 1000);
    sets(BOT0);
    joins(BOT0, 0, 0);
    after(1000);
    Monitors monitors = new Monitors(List.of(new TrafficProgress(80 * SECOND_NS, List.of())));
    events.forEach(monitors::observe);
    monitors.finish(nowNs);
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aCarThatNeverDepartsIsReportedAtTheBound() {
    joins(BOT0, 0, 0);
    sets(BOT0, "A", "A1");
    sets(BOT1, "B", "B1");
    joins(BOT1, 0, 1000);
    after(10);
    events.add(new TraceEvent.Left(nowNs, BOT1));
    after(1000);
    assertRed(
        report(new TrafficProgress(130 * SECOND_NS, List.of())),
        "intersection.traffic_progress",
        130,
        BOT0);
  }
}

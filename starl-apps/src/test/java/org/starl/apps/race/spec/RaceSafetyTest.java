package org.starl.apps.race.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.apps.race.logic.RaceApp.Location;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastId;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.shape.Shapes;
import org.starl.spec.Monitors;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** The safety of a race on handwritten traces: a body of 165 mm, a point of 75 mm. */
class RaceSafetyTest {

  private static final RobotId ROBOT = new RobotId("bot0");
  private static final RobotId OTHER = new RobotId("bot1");

  // From there a robot may win after three motions in vain.
  private static final double AFAR_MM = 400;

  private final Monitors monitors =
      new Monitors(List.of(new RaceSafety(List.of(new RacePoint("goal", new Point(0, 0), 75)))));

  RaceSafetyTest() {
    monitors.observe(new Variable(0, ROBOT, Instance.APP, RaceFact.POINT, "goal"));
  }

  private static void place(Monitors monitors, RobotId robot, double awayMm) {
    monitors.observe(new Joined(0, robot, new Pose(awayMm, 0, 0), 165));
  }

  /** A motion ends in vain so far from the point. */
  private void fail(double awayMm) {
    place(monitors, ROBOT, awayMm);
    for (MotionFlag flag : List.of(MotionFlag.MOVING, MotionFlag.FAIL)) {
      monitors.observe(new Variable(0, ROBOT, MotionFact.SOURCE, MotionFact.FLAG, flag));
    }
  }

  private void enter(long atMs, Location location) {
    monitors.observe(
        new Variable(atMs * Time.NS_PER_MS, ROBOT, Instance.APP, RaceFact.LOCATION, location));
  }

  private void take(RobotId robot, long claimedNs) {
    take(robot, new RaceFact.Taken(0, "goal", OTHER, claimedNs, 0));
  }

  private void take(RobotId robot, RaceFact.Taken taken) {
    monitors.observe(Action.of(0, robot, Instance.APP, RaceFact.Taken.SHAPE, taken));
  }

  private void arrive(double awayMm) {
    RaceFact.Arrived arrived = new RaceFact.Arrived(0, "goal", awayMm, 0, Math.max(75, awayMm));
    monitors.observe(Action.of(0, ROBOT, Instance.APP, RaceFact.Arrived.SHAPE, arrived));
  }

  private long winsFromAfar() {
    arrive(AFAR_MM);
    take(ROBOT, new RaceFact.Taken(0, "goal", ROBOT, 1, (int) AFAR_MM));
    return monitors.report().violations("race.at_the_point");
  }

  @Test
  void aRobotMayWinFromAfarAfterThreeMotionsThatBroughtItNoNearer() {
    for (double mm : List.of(AFAR_MM, AFAR_MM + 100, AFAR_MM)) {
      fail(mm);
    }
    assertThat(winsFromAfar()).isZero();
  }

  @Test
  void motionsBeforeOneThatBroughtItNearerDoNotCount() {
    for (double mm : List.of(AFAR_MM + 600, AFAR_MM + 600, AFAR_MM)) {
      fail(mm);
    }
    assertThat(winsFromAfar()).isEqualTo(2); // it is told, and claimed
  }

  @Test
  void aRobotAtThePointWasNotKeptOff() {
    place(monitors, ROBOT, 50);
    arrive(50);
    take(ROBOT, new RaceFact.Taken(0, "goal", ROBOT, 1, 50));
    assertThat(monitors.report().violations("race.at_the_point")).isEqualTo(1);
    assertThat(monitors.report().violations("race.truly_won")).isZero();
  }

  @Test
  void aRobotThatKnowsAllWinnersDrivesNoFurther() {
    monitors.observe(new Variable(0, ROBOT, MotionFact.SOURCE, MotionFact.FLAG, MotionFlag.MOVING));
    monitors.observe(new Variable(0, ROBOT, MotionFact.SOURCE, MotionFact.FLAG, MotionFlag.IDLE));
    enter(100, Location.TELL);
    assertThat(monitors.report().violations("race.moves_on")).isZero();
    monitors.observe(new Variable(0, ROBOT, MotionFact.SOURCE, MotionFact.FLAG, MotionFlag.MOVING));
    enter(200, Location.TELL);
    assertThat(monitors.report().violations("race.moves_on")).isEqualTo(1);
  }

  @Test
  void aRobotMakesWayForThreeSecondsUnlessThePointIsWon() {
    enter(0, Location.MAKE_WAY);
    enter(3_000, Location.RACE);
    enter(4_000, Location.MAKE_WAY);
    enter(4_100, Location.PICK);
    enter(4_200, Location.RACE);
    assertThat(monitors.report().violations("race.makes_way")).isZero();
    enter(5_000, Location.MAKE_WAY);
    enter(6_000, Location.RACE);
    assertThat(monitors.report().violations("race.makes_way")).isEqualTo(1);
  }

  private void passes(long atMs, RobotId robot, int distanceMm) {
    RaceFact.Way way = new RaceFact.Way(robot, 0, distanceMm);
    monitors.observe(
        Action.of(atMs * Time.NS_PER_MS, ROBOT, Instance.APP, RaceFact.Way.SHAPE, way));
  }

  @Test
  void aRobotMakesWayAsLongAsANearerOneHasIt() {
    enter(0, Location.RACE);
    passes(1_000, OTHER, 300);
    enter(1_100, Location.MAKE_WAY);
    enter(9_000, Location.RACE);
    assertThat(monitors.report().violations("race.makes_way")).isZero();
    passes(10_000, OTHER, 300);
    enter(10_100, Location.MAKE_WAY);
    enter(14_000, Location.RACE);
    assertThat(monitors.report().violations("race.makes_way")).isEqualTo(1);
    enter(16_000, Location.PICK); // only then, though it has known for long
    assertThat(monitors.report().violations("race.makes_way")).isEqualTo(2);
  }

  @Test
  void whileARobotHasTheWayOnlyANearerOneGetsIt() {
    passes(0, OTHER, 300);
    passes(1_000, ROBOT, 200);
    passes(9_000, OTHER, 400);
    assertThat(monitors.report().violations("race.makes_way")).isZero();
    passes(10_000, ROBOT, 500);
    assertThat(monitors.report().violations("race.makes_way")).isEqualTo(1);
  }

  @Test
  void aRobotThatHasTheWayDoesNotAskAnew() {
    passes(0, ROBOT, 300);
    passes(8_000, ROBOT, 200);
    assertThat(monitors.report().violations("race.makes_way")).isZero();
    passes(10_000, ROBOT, 100);
    assertThat(monitors.report().violations("race.makes_way")).isEqualTo(1);
  }

  private void asksAround(Point at) {
    GeocastId m = new GeocastId(ProcessId.first(ROBOT, 1), 1);
    GeocastFact.do_geocast asks = new GeocastFact.do_geocast(m, new Circle(at, 2_000), 1);
    monitors.observe(Action.of(0, ROBOT, Instance.of("geocast"), GeocastFact.SHAPE, asks));
  }

  @Test
  void theWayThatARobotAsksForIsThatToItsPoint() {
    passes(0, OTHER, 300);
    asksAround(new Point(0, 0));
    assertThat(monitors.report().violations("race.makes_way")).isZero();
    asksAround(new Point(500, 0));
    assertThat(monitors.report().violations("race.makes_way")).isEqualTo(1);
  }

  private long drawsBackTo(double xMm) {
    place(monitors, ROBOT, 400);
    MotionFact.doMove move = new MotionFact.doMove(new ItemPosition("back", xMm, 0), new Nowhere());
    monitors.observe(Action.of(0, ROBOT, MotionFact.SOURCE, MotionFact.SHAPE, move));
    return monitors.report().violations("race.makes_way");
  }

  @Test
  void aRobotDrawsBackAwayFromItsPoint() {
    assertThat(drawsBackTo(1_000)).isZero();
    assertThat(drawsBackTo(-300)).isEqualTo(1);
  }

  @Test
  void aRobotIsDoneWhenTheOthersKnowAsGoodAWinner() {
    place(monitors, ROBOT, 0);
    place(monitors, OTHER, 0);
    take(ROBOT, 1);
    take(OTHER, 2);
    enter(0, Location.TELL);
    enter(100, Location.DONE);
    assertThat(monitors.report().violations("race.confirmed")).isEqualTo(1);
    take(OTHER, 1);
    enter(200, Location.DONE);
    assertThat(monitors.report().violations("race.confirmed")).isEqualTo(1);
  }

  @Test
  void aWinnerIsReplacedOnlyByOneThatWasThereEarlier() {
    List<RaceFact.Taken> better =
        List.of(
            new RaceFact.Taken(0, "goal", OTHER, 1, 50),
            new RaceFact.Taken(0, "goal", ROBOT, 7, 0),
            new RaceFact.Taken(0, "goal", OTHER, 6, 0),
            new RaceFact.Taken(0, "goal", ROBOT, 6, 0));
    better.forEach(claim -> take(ROBOT, claim));
    assertThat(monitors.report().violations("race.one_winner")).isZero();
    for (int i = better.size() - 1; i >= 0; i--) {
      take(ROBOT, better.get(i));
    }
    assertThat(monitors.report().violations("race.one_winner")).isEqualTo(better.size());
  }

  @Test
  void aWinnerThatIsNotAnnouncedAtOnceViolatesAnnounced() {
    RaceFact.Taken taken = new RaceFact.Taken(0, "goal", OTHER, 1, 0);
    take(ROBOT, taken);
    monitors.observe(announces(0, taken));
    enter(1, Location.PICK);
    assertThat(monitors.report().checks("race.announced")).isEqualTo(1);
    assertThat(monitors.report().violations("race.announced")).isZero();
    take(OTHER, taken);
    monitors.observe(announces(0, taken)); // another robot's
    monitors.observe(announces(1, taken));
    assertThat(monitors.report().violations("race.announced")).isEqualTo(1);
  }

  private static Sent announces(long atMs, RaceFact.Taken taken) {
    Instance race = Instance.of(GeocastFact.BROADCAST, "race");
    return new Sent(
        atMs * Time.NS_PER_MS,
        ROBOT,
        Sent.ALL,
        race,
        1,
        1,
        GeocastMessage.shape(Shapes.INT),
        new GeocastMessage.Copy<>(
            new GeocastId(ProcessId.first(ROBOT, 1), 1), new Everywhere(), 0, 1, taken.claim()));
  }
}

package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

class RequireTest {

  private static final long S = 1_000_000_000;
  private static final double RADIUS_MM = 100;
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final Circle DOCK = new Circle(new Point(0, 0), 300);

  private enum Mode {
    IDLE,
    BUSY
  }

  private static final Var<Mode> MODE = Var.of("mode", Mode.class);

  private static List<Violation> violations(Monitor monitor, long endNs, TraceEvent... events) {
    Monitors monitors = new Monitors(List.of(monitor));
    List.of(events).forEach(monitors::observe);
    monitors.finish(endNs);
    assertThat(monitors.report().checks("L")).isPositive();
    return monitors.report().violations();
  }

  private static Joined joined(long atNs, RobotId robot, double xMm) {
    return new Joined(atNs, robot, new Pose(xMm, 0, 0), RADIUS_MM);
  }

  /** The robot drives along the x axis. */
  private static Moved moved(long atNs, RobotId robot, double xMm, double mmPerS) {
    return new Moved(atNs, robot, new Pose(xMm, 0, 0), mmPerS, 0);
  }

  @Test
  void bodiesThatMeetInTheRegionBetweenTwoEventsViolateNeverTwo() {
    List<Violation> found =
        violations(
            Require.neverTwoIn("L", DOCK),
            20 * S,
            joined(0, A, 0),
            joined(0, B, -1000),
            moved(0, B, -1000, 100));
    assertThat(found).hasSize(1);
    // B touches the region after 600 mm.
    assertThat(found.get(0).timeNs()).isBetween(6 * S, 6 * S + 40_000_000);
    assertThat(found.get(0).robots()).containsExactly(A, B);
    assertThat(found.get(0).detail()).isEqualTo("all of them are in circle(0.0 0.0 300.0)");
  }

  @Test
  void robotsInTheRegionOneAfterTheOtherKeepNeverTwo() {
    assertThat(
            violations(
                Require.neverTwoIn("L", DOCK),
                20 * S,
                joined(0, A, 0),
                joined(0, B, -1000),
                moved(0, A, 0, 100),
                moved(0, B, -1000, 100)))
        .isEmpty();
  }

  @Test
  void aRobotThatReachesItsRegionInTimeKeepsEventually() {
    assertThat(
            violations(
                Require.eventuallyIn("L", DOCK, Duration.ofSeconds(8)),
                20 * S,
                joined(0, A, -1000),
                moved(0, A, -1000, 100)))
        .isEmpty();
  }

  @Test
  void aRobotThatIsTooSlowViolatesEventually() {
    List<Violation> found =
        violations(
            Require.eventuallyIn("L", DOCK, Duration.ofSeconds(6)),
            20 * S,
            joined(0, A, -1000),
            moved(0, A, -1000, 100));
    assertThat(found)
        .containsExactly(
            new Violation(
                "L", 6 * S, List.of(A), "has not been in circle(0.0 0.0 300.0)", false, DOCK));
  }

  @Test
  void theTimeOfEventuallyBeginsAgainAfterAFault() {
    Fault begin = new Fault(2 * S, Fault.WORLD, Fault.BEGIN, "loss(0.9)");
    Fault end = new Fault(5 * S, Fault.WORLD, Fault.END, "loss(0.9)");
    Monitor monitor = Require.eventuallyIn("L", DOCK, Duration.ofSeconds(6));
    List<Violation> found = violations(monitor, 20 * S, joined(0, A, -1000), begin, end);
    assertThat(found).extracting(Violation::timeNs).containsExactly(11 * S);
  }

  @Test
  void theTimeOfEventuallyBeginsAgainAfterARestart() {
    Fault crash = new Fault(2 * S, A, Fault.CRASH, "");
    Fault restart = new Fault(5 * S, A, Fault.RESTART, "");
    Monitor monitor = Require.eventuallyIn("L", DOCK, Duration.ofSeconds(6));
    List<Violation> found = violations(monitor, 20 * S, joined(0, A, -1000), crash, restart);
    assertThat(found).extracting(Violation::timeNs).containsExactly(11 * S);
  }

  @Test
  void aRobotThatHasLeftOwesNothing() {
    Monitor monitor = Require.eventuallyIn("L", DOCK, Duration.ofSeconds(6));
    List<Violation> found =
        violations(monitor, 20 * S, joined(0, A, 0), joined(0, B, -1000), new Left(S, B));
    assertThat(found).isEmpty();
  }

  @Test
  void alwaysReportsTheMomentInWhichTheConditionBreaks() {
    Monitor monitor =
        Require.always("L", "a is idle", state -> state.variable(A, MODE) != Mode.BUSY);
    List<Violation> found =
        violations(
            monitor,
            4 * S,
            joined(0, A, 0),
            new Variable(S, A, Instance.APP, MODE, Mode.IDLE),
            new Variable(2 * S, A, Instance.APP, MODE, Mode.BUSY),
            new Variable(3 * S, A, Instance.APP, MODE, Mode.IDLE));
    assertThat(found)
        .containsExactly(new Violation("L", 2 * S, List.of(A), "does not hold: a is idle"));
  }

  @Test
  void alwaysSeesBodiesBetweenEvents() {
    Monitor monitor = Require.always("L", "a stays left", state -> state.pose(A).xMm() < 500);
    List<Violation> found = violations(monitor, 20 * S, joined(0, A, 0), moved(0, A, 0, 100));
    assertThat(found).hasSize(1);
    assertThat(found.get(0).timeNs()).isBetween(5 * S, 5 * S + 40_000_000);
  }

  @Test
  void atTheEndJudgesTheEndAlone() {
    List<Violation> good = violations(isRight(), 10 * S, joined(0, A, 0), moved(0, A, 0, 100));
    assertThat(good).isEmpty();
    List<Violation> bad =
        violations(isRight(), 10 * S, joined(0, A, 1000), moved(0, A, 1000, -100));
    assertThat(bad)
        .containsExactly(
            new Violation("L", 10 * S, List.of(A), "does not hold at the end: a is on the right"));
  }

  private static Monitor isRight() {
    return Require.atTheEnd("L", "a is on the right", state -> state.pose(A).xMm() > 500);
  }
}

package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

class TubesSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final Instance X = Instance.of(TubeFact.PRIMITIVE, "x");
  private static final long S = 1_000_000_000;

  private final Monitors monitors = new Monitors(List.of(new TubesSpec(10 * S)));

  @Test
  void separateTubesSatisfyTheSpecification() {
    holds(1, A, X, tube(300, 0, 0, 1000, 0));
    holds(2, B, X, tube(300, 0, 601, 1000, 601), tube(300, 2000, 0));
    assertThat(monitors.report().holds()).isTrue();
    assertThat(monitors.report().checks(TubesSpec.TUBES)).isEqualTo(2);
  }

  @Test
  void tubesThatMeetViolateTubesEvenAfterACrash() {
    holds(1, A, X, tube(300, 0, 0, 1000, 0));
    monitors.observe(new Fault(2, A, Fault.CRASH, ""));
    holds(3, B, X, tube(300, 500, -900, 500, 900));
    assertThat(monitors.report().violations(TubesSpec.TUBES)).isEqualTo(1);
  }

  @Test
  void releasedTubesAreFreeAndInstancesAreIndependent() {
    holds(1, A, X, tube(300, 0, 0, 1000, 0));
    holds(2, A, X, tube(300, 1000, 0));
    holds(3, B, X, tube(300, 0, 0));
    holds(4, B, Instance.of(TubeFact.PRIMITIVE, "y"), tube(300, 1000, 0));
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aBodyThatLeavesItsTubeViolatesInsideOnce() {
    monitors.observe(new Joined(0, A, new Pose(0, 0, 0), 165));
    holds(0, A, X, tube(300, 0, 0, 1000, 0));
    monitors.observe(new Moved(0, A, new Pose(0, 0, StrictMath.PI / 2), 100, 0));
    monitors.observe(new Moved(S, A, new Pose(0, 100, 0), 0, 0));
    assertThat(monitors.report().holds()).isTrue();
    monitors.observe(new Moved(2 * S, A, new Pose(0, 100, StrictMath.PI / 2), 100, 0));
    monitors.finish(3 * S);
    assertThat(monitors.report().violations(TubesSpec.INSIDE)).isEqualTo(1);
    assertThat(monitors.report().violations().get(0).timeNs())
        .isBetween(2_350 * S / 1000, 2_380 * S / 1000);
  }

  @ParameterizedTest
  @CsvSource({"35, 0", "36, 1"})
  void aPartThatIsFreedBeforeTheBodyIsCertainlyInTheRestViolatesFreed(
      double errorMm, int violations) {
    monitors.observe(new Joined(0, A, new Pose(1000, 100, 0), 165));
    TubeList rest = new TubeList(List.of(tube(300, 1000, 0, 2000, 0)));
    TubeFact frees = new TubeFact.frees(rest, 1000, 100, errorMm);
    monitors.observe(Action.of(S, A, X, TubeFact.SHAPE, frees));
    assertThat(monitors.report().checks(TubesSpec.FREED)).isEqualTo(1);
    assertThat(monitors.report().violations(TubesSpec.FREED)).isEqualTo(violations);
  }

  @Test
  void aTubeOverARobotThatHoldsNoneYetViolatesTubes() {
    monitors.observe(new Joined(0, B, new Pose(500, 0, 0), 165));
    holds(0, B, X);
    holds(1, A, X, tube(300, 0, 600, 1000, 600));
    assertThat(monitors.report().violations(TubesSpec.TUBES)).isZero();
    holds(2, A, X, tube(300, 0, 400, 1000, 400));
    assertThat(monitors.report().violations(TubesSpec.TUBES)).isEqualTo(1);
  }

  @Test
  void aRobotThatDrivesAfterItsDriveViolatesTold() {
    monitors.observe(new Joined(0, A, new Pose(0, 0, 0), 165));
    monitors.observe(new Variable(0, A, X, TubeFact.FLAG, TubeFlag.MOVING));
    monitors.observe(new Moved(S, A, new Pose(0, 0, 0), 100, 0));
    monitors.observe(new Variable(2 * S, A, X, TubeFact.FLAG, TubeFlag.FAIL));
    monitors.observe(new Moved(2 * S + S / 2, A, new Pose(150, 0, 0), 100, 0));
    assertThat(monitors.report().violations(TubesSpec.TOLD)).isZero();
    monitors.observe(new Moved(4 * S, A, new Pose(300, 0, 0), 0, 0));
    assertThat(monitors.report().violations(TubesSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aGoToThatIsNeitherDoneNorFailedInTimeViolatesTold() {
    goTo(S, A);
    goTo(S, B);
    monitors.observe(new Variable(9 * S, A, X, TubeFact.FLAG, TubeFlag.FAIL));
    monitors.finish(12 * S);
    assertThat(monitors.report().violations(TubesSpec.TOLD)).isEqualTo(1);
    assertThat(monitors.report().violations().get(0).robots()).containsExactly(B);
  }

  @Test
  void aCrashedRobotOwesNothing() {
    holds(0, A, X, tube(300, 0, 0));
    goTo(S, A);
    monitors.observe(new Fault(2 * S, A, Fault.CRASH, ""));
    monitors.finish(30 * S);
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aDriveThatKeepsWhatItHasPassedViolatesPassed() {
    monitors.observe(new Joined(0, A, new Pose(2000, 0, 0), 165));
    flag(0, TubeFlag.MOVING);
    holds(1, A, X, tube(300, 0, 0, 1000, 0, 3000, 0));
    holds(2 * S, A, X, tube(300, 1000, 0, 3000, 0));
    assertThat(monitors.report().holds()).isTrue();
    holds(5 * S, A, X, tube(300, 0, 0, 1000, 0, 3000, 0));
    holds(11 * S, A, X, tube(300, 1000, 0, 3000, 0));
    assertThat(monitors.report().violations(TubesSpec.PASSED)).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({"DONE, 1", "FAIL, 0", "PLANNING, 0"})
  void aRobotThatHasArrivedAndHoldsALegViolatesPassed(TubeFlag flag, int violations) {
    monitors.observe(new Joined(0, A, new Pose(1000, 0, 0), 165));
    flag(0, TubeFlag.MOVING);
    holds(1, A, X, tube(300, 0, 0, 1000, 0));
    flag(S, flag);
    monitors.finish(9 * S);
    assertThat(monitors.report().violations(TubesSpec.PASSED)).isEqualTo(violations);
  }

  @ParameterizedTest
  @CsvSource({"crash, 0", "restart, 1"})
  void aSecondTubeThatIsKeptViolatesPassedButNotAfterACrash(String fault, int violations) {
    monitors.observe(new Joined(0, A, new Pose(0, 0, 0), 165));
    holds(0, A, X, tube(300, 0, 0));
    flag(0, TubeFlag.MOVING);
    monitors.observe(new Fault(1, A, fault, ""));
    holds(2, A, X, tube(300, 0, 0), tube(300, 0, 0, 1000, 0));
    flag(S, TubeFlag.FAIL);
    monitors.finish(9 * S);
    assertThat(monitors.report().violations(TubesSpec.PASSED)).isEqualTo(violations);
  }

  @Test
  void whileAFaultIsActivePassedIsNotRequired() {
    monitors.observe(new Fault(0, Fault.WORLD, Fault.BEGIN, "disk"));
    aRobotThatHasArrivedAndHoldsALegViolatesPassed(TubeFlag.DONE, 0);
  }

  @Test
  void aFailureOfADriveThatIsOverViolatesTold() {
    flag(S, TubeFlag.MOVING);
    monitors.observe(new Variable(2 * S, A, X, TubeFact.FAILURE, TubeFailure.STOPPED));
    flag(2 * S, TubeFlag.FAIL);
    assertThat(monitors.report().violations(TubesSpec.TOLD)).isZero();
    monitors.observe(new Variable(3 * S, A, X, TubeFact.FAILURE, TubeFailure.MOTION));
    assertThat(monitors.report().violations(TubesSpec.TOLD)).isEqualTo(1);
  }

  private void flag(long timeNs, TubeFlag flag) {
    monitors.observe(new Variable(timeNs, A, X, TubeFact.FLAG, flag));
  }

  private void goTo(long timeNs, RobotId robot) {
    TubeFact goTo = new TubeFact.goTo(new TubeGoal.Place(new ItemPosition("goal", 0, 0)));
    monitors.observe(Action.of(timeNs, robot, X, TubeFact.SHAPE, goTo));
  }

  private void holds(long timeNs, RobotId robot, Instance source, Tube... tubes) {
    TubeList held = new TubeList(List.of(tubes));
    monitors.observe(new Variable(timeNs, robot, source, TubeFact.HELD, held));
  }

  /** A tube along the points x, y, x, y, ... */
  private static Tube tube(int radiusMm, int... xy) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < xy.length; i += 2) {
      points.add(new Point(xy[i], xy[i + 1]));
    }
    return new Tube(points, radiusMm);
  }
}

package org.starl.primitives.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFailure;
import org.starl.motion.MotionFlag;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

class MotionSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final long MS = 1_000_000;
  private static final Pose HERE = new Pose(0, 0, 0);
  private static final ItemPosition TARGET = new ItemPosition("target", 3000, 0);
  private static final Region CIRCLE = new Circle(new Point(2000, 0), 300);

  private final Monitors monitors =
      new Monitors(
          List.of(new MotionSpec(MotionParameters.DEFAULT.toBuilder().reactionMs(50).build())));

  @Test
  void aRobotThatStopsInTimeStands() {
    drivesAndHas(MotionFlag.FAIL);
    monitors.observe(new Moved(1_049 * MS, A, HERE, 0, 0));
    monitors.observe(says(2_000, MotionFlag.MOVING));
    monitors.observe(new Moved(2_000 * MS, A, HERE, 100, 0));
    monitors.finish(5_000 * MS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isZero();
  }

  @Test
  void aRobotThatDrivesOnAfterAFailureViolatesTold() {
    drivesAndHas(MotionFlag.FAIL);
    monitors.finish(1_051 * MS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotThatTurnsAgainAfterMotionStopViolatesTold() {
    drivesAndHas(MotionFlag.IDLE);
    monitors.observe(new Moved(1_000 * MS, A, HERE, 0, 0));
    monitors.observe(new Moved(3_000 * MS, A, HERE, 0, 1));
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotOfARunInRealTimeMayStopLate() {
    monitors.observe(Fault.realTime(0));
    drivesAndHas(MotionFlag.FAIL);
    monitors.finish(5_000 * MS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isZero();
  }

  @Test
  void aMotionThatIsHeldBackWaitsBeforeItFails() {
    moves(1_000, CIRCLE);
    monitors.observe(new Moved(2_000 * MS, A, HERE, 0, 0));
    fails(2_260, MotionFailure.IN_THE_WAY);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isZero();
  }

  @Test
  void aMotionThatFailsAtOnceWhenItIsHeldBackViolatesTold() {
    moves(1_000, CIRCLE);
    monitors.observe(new Moved(2_000 * MS, A, HERE, 0, 0));
    fails(2_060, MotionFailure.IN_THE_WAY);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aMotionThatFailsWithoutProgressTooEarlyViolatesTold() {
    moves(1_000, new Nowhere());
    fails(5_000, MotionFailure.NO_PROGRESS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({"9000,1", "10000,0"})
  void aMotionHasItsPatienceAnewOnAWayThatIsPlanned(long atMs, int violations) {
    moves(1_000, new Nowhere());
    Point aside = new Point(1000, 1000);
    monitors.observe(tells(5_000, new MotionFact.planned(List.of(aside, TARGET.at()))));
    fails(atMs, MotionFailure.NO_PROGRESS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(violations);
  }

  @Test
  void aClockThatIsSetAheadExcusesAnEarlyFailure() {
    moves(1_000, new Nowhere());
    monitors.observe(new Fault(2_000 * MS, A, Fault.BEGIN, "skew", "skew(a,5s)"));
    fails(3_000, MotionFailure.NO_PROGRESS);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isZero();
  }

  @Test
  void aRobotThatStandsForLongDuringItsMoveViolatesTold() {
    moves(1_000, new Nowhere());
    monitors.observe(new Moved(2_000 * MS, A, HERE, 0, 0));
    monitors.observe(new Moved(9_000 * MS, A, HERE, 100, 0));
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  /** After 22 s, and 2500 mm at 25 mm/s. */
  @ParameterizedTest
  @CsvSource({"122900,1", "123000,0"})
  void aMotionThatFailsAsTooSlowBeforeItsTimeIsOverViolatesTold(long atMs, int violations) {
    moves(1_000, new Nowhere());
    fails(atMs, MotionFailure.TOO_SLOW);
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(violations);
  }

  @ParameterizedTest
  @CsvSource({"NO_FIX,dropout", "CONTRADICTED,jump", "UNCERTAIN,noise"})
  void aMotionThatFailsForItsFixesWithoutAFaultOfThemViolatesTold(
      MotionFailure why, String effect) {
    for (String other : List.of("dropout", "jump", "noise", "slow")) {
      Monitors own = located();
      moves(own, 1_000, new Nowhere());
      own.observe(new Fault(2_000 * MS, A, Fault.BEGIN, other, other + "(a)"));
      own.observe(new Moved(2_300 * MS, A, HERE, 0, 0));
      fails(own, 4_250, why);
      assertThat(own.report().violations(MotionSpec.TOLD)).isEqualTo(other.equals(effect) ? 0 : 1);
    }
  }

  @Test
  void afterADropoutNoFixIsNoTrueReason() {
    Monitors own = located();
    moves(own, 1_000, new Nowhere());
    own.observe(new Fault(2_000 * MS, A, Fault.BEGIN, "dropout", "dropout(a)"));
    own.observe(new Moved(2_300 * MS, A, HERE, 0, 0));
    own.observe(new Fault(3_900 * MS, A, Fault.END, "dropout", "dropout(a)"));
    fails(own, 4_250, MotionFailure.NO_FIX);
    assertThat(own.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aMotionThatFailsForItsFixesBeforeItHasWaitedViolatesTold() {
    Monitors own = located();
    moves(own, 1_000, new Nowhere());
    own.observe(new Fault(2_000 * MS, A, Fault.BEGIN, "noise", "noise(a,2m)"));
    own.observe(new Moved(5_000 * MS, A, HERE, 0, 0));
    fails(own, 5_100, MotionFailure.UNCERTAIN);
    assertThat(own.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({"dropout,1", "jump,1", "noise,0"})
  void aMotionWithoutAGoodFixThatDoesNotFailViolatesTold(String effect, int violations) {
    Monitors own = located();
    moves(own, 1_000, new Nowhere());
    own.observe(new Fault(2_000 * MS, A, Fault.BEGIN, effect, effect + "(a)"));
    own.observe(new Fault(4_600 * MS, A, Fault.END, effect, effect + "(a)"));
    own.finish(5_000 * MS);
    assertThat(own.report().violations(MotionSpec.TOLD)).isEqualTo(violations);
  }

  @Test
  void aMotionThatHasAGoodFixInTimeNeedNotFail() {
    Monitors own = located();
    moves(own, 1_000, new Nowhere());
    own.observe(new Fault(2_000 * MS, A, Fault.BEGIN, "dropout", "dropout(a)"));
    own.observe(new Fault(4_000 * MS, A, Fault.END, "dropout", "dropout(a)"));
    own.finish(5_000 * MS);
    assertThat(own.report().violations(MotionSpec.TOLD)).isZero();
  }

  @Test
  void aRobotThatBumpsAndDoesNotBackOffViolatesTold() {
    Monitors backing = new Monitors(List.of(backingOff()));
    bumps(backing);
    assertThat(backing.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotThatGoesOnAfterABumpDoesNotFailForIt() {
    CollisionPolicy policy = CollisionPolicy.USE_COLAVOID;
    Monitors avoiding =
        new Monitors(
            List.of(new MotionSpec(MotionParameters.builder().collisionPolicy(policy).build())));
    bumps(avoiding);
    assertThat(avoiding.report().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotWithAnotherBehindItNeedNotBackOff() {
    Monitors backing = new Monitors(List.of(backingOff()));
    backing.observe(new Joined(0, new RobotId("b"), new Pose(-340, 0, 0), 165));
    bumps(backing);
    assertThat(backing.report().violations(MotionSpec.TOLD)).isZero();
  }

  @ParameterizedTest
  @CsvSource({"9000, 0", "16000, 1"})
  void aMotionWhoseWheelsAreStuckForLongViolatesTold(long goesOnMs, int violations) {
    moves(1_000, new Nowhere());
    monitors.observe(new Fault(1_000 * MS, A, Fault.BEGIN, "stuck", "stuck(a)"));
    monitors.observe(new Moved(1_000 * MS, A, HERE, 0, 0));
    monitors.observe(new Moved(goesOnMs * MS, A, HERE, 100, 0));
    assertThat(monitors.report().violations(MotionSpec.TOLD)).isEqualTo(violations);
  }

  @ParameterizedTest
  @CsvSource({"0.1, 0.1, 0", "0.1, 0.2, 0", "0.2, 0.1, 1", "-0.2, 0.1, 1"})
  void aHeadingOutsideItsBoundViolatesLocated(double offRad, double errorRad, int violations) {
    Monitors own = located();
    Deviation deviation = new Deviation(0, 0, offRad, 0, errorRad);
    own.observe(new Variable(0, A, Deviation.SOURCE, Deviation.VAR, deviation));
    assertThat(own.report().violations(MotionSpec.LOCATED)).isEqualTo(violations);
  }

  private static Monitors located() {
    return new Monitors(List.of(new MotionSpec().located()));
  }

  private static MotionSpec backingOff() {
    MotionParameters parameters =
        MotionParameters.builder().collisionPolicy(CollisionPolicy.USE_COLBACK).build();
    return new MotionSpec(parameters).backingOff(Obstacles.NONE);
  }

  private static void bumps(Monitors backing) {
    moves(backing, 1_000, new Nowhere());
    backing.observe(new Moved(2_000 * MS, A, HERE, 0, 0));
    fails(backing, 2_800, MotionFailure.BUMPED);
  }

  private void moves(long atMs, Region avoid) {
    moves(monitors, atMs, avoid);
  }

  private static void moves(Monitors monitors, long atMs, Region avoid) {
    monitors.observe(new Joined(0, A, HERE, 165));
    monitors.observe(tells(atMs, new MotionFact.doMove(TARGET, avoid)));
    monitors.observe(says(atMs, MotionFlag.MOVING));
    monitors.observe(new Moved(atMs * MS, A, HERE, 100, 0));
  }

  private void fails(long atMs, MotionFailure why) {
    fails(monitors, atMs, why);
  }

  private static void fails(Monitors monitors, long atMs, MotionFailure why) {
    monitors.observe(tells(atMs, new MotionFact.failed(why)));
  }

  private static Action tells(long atMs, MotionFact fact) {
    return Action.of(atMs * MS, A, MotionFact.SOURCE, MotionFact.SHAPE, fact);
  }

  private static Variable says(long atMs, MotionFlag flag) {
    return new Variable(atMs * MS, A, MotionFact.SOURCE, MotionFact.FLAG, flag);
  }

  private void drivesAndHas(MotionFlag flag) {
    monitors.observe(new Joined(0, A, HERE, 165));
    monitors.observe(new Moved(0, A, HERE, 100, 0));
    monitors.observe(says(1_000, flag));
  }
}

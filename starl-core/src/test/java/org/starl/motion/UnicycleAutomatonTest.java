package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.starl.motion.MotionState.ARCING;
import static org.starl.motion.MotionState.GOAL;
import static org.starl.motion.MotionState.SMALLTURN;
import static org.starl.motion.MotionState.STRAIGHT;
import static org.starl.motion.MotionState.TURN;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/** The original StarL's transition table, and what each state commands. */
class UnicycleAutomatonTest {

  private static final Point TARGET = new Point(0, 0);

  private MotionParameters parameters = MotionParameters.DEFAULT;
  private MotionAutomaton automaton = MotionAutomaton.goTo(TARGET, true, parameters, new Rng(1));
  private long nowNs;

  private void begin(MotionParameters newParameters) {
    parameters = newParameters;
    automaton = MotionAutomaton.goTo(TARGET, true, parameters, new Rng(1));
  }

  /** A step from where the target is this far, and to the left of the heading by this angle. */
  private WheelCommand see(double distanceMm, double bearingDeg) {
    nowNs += 60_000_000;
    Pose pose = new Pose(-distanceMm, 0, Angles.fromDegrees(-bearingDeg));
    return automaton.step(pose, Bumps.NONE, nowNs);
  }

  @ParameterizedTest(name = "from {0}: {1} mm at {2} degrees leads to {3}")
  @CsvSource({
    "INIT, 75, 120, GOAL",
    "INIT, 76, 20, ARCING",
    "INIT, 700, 25, ARCING",
    "INIT, 700, 26, TURN",
    "INIT, 701, 20, TURN",
    "INIT, 701, 2, STRAIGHT",
    "ARCING, 400, 29, ARCING",
    "ARCING, 400, -31, TURN",
    "ARCING, 400, 5, STRAIGHT",
    "ARCING, 400, 6.5, ARCING",
    "ARCING, 74, 10, GOAL",
    "STRAIGHT, 900, 2.9, STRAIGHT",
    "STRAIGHT, 900, 3.1, SMALLTURN",
    "STRAIGHT, 900, -24, SMALLTURN",
    "STRAIGHT, 900, 25.1, TURN",
    "STRAIGHT, 75, 170, GOAL",
    "TURN, 900, 3.1, TURN",
    "TURN, 900, -2.9, STRAIGHT",
    "TURN, 900, 179, TURN",
    "TURN, 70, 90, GOAL",
    "SMALLTURN, 900, 10, SMALLTURN",
    "SMALLTURN, 900, 2.9, STRAIGHT",
    "SMALLTURN, 900, 26, TURN",
    "SMALLTURN, 70, 10, GOAL",
  })
  void aStepChangesTheState(
      MotionState from, double distanceMm, double bearingDeg, MotionState to) {
    enter(from);
    see(distanceMm, bearingDeg);
    assertThat(automaton.state()).isEqualTo(to);
    assertThat(automaton.status()).isEqualTo(to == GOAL ? MotionFlag.DONE : MotionFlag.MOVING);
  }

  private void enter(MotionState state) {
    switch (state) {
      case ARCING -> see(600, 20);
      case STRAIGHT -> see(1000, 0);
      case TURN -> see(1000, 90);
      case SMALLTURN -> {
        see(1000, 0);
        see(1000, 10);
      }
      default -> {}
    }
    assertThat(automaton.state()).isEqualTo(state);
  }

  @Test
  void arcingCanBeTurnedOff() {
    begin(MotionParameters.builder().enableArcing(false).build());
    see(600, 20);
    assertThat(automaton.state()).isEqualTo(TURN);
  }

  @Test
  void itTurnsTowardsTheTargetFastThenSlow() {
    assertThat(see(1000, 90)).isEqualTo(new WheelCommand(0, Angles.fromDegrees(110)));
    double slower = see(1000, -14).angularRadPerS();
    assertThat(Angles.toDegrees(slower)).isCloseTo(-67.5, within(1e-9));
    assertThat(Angles.toDegrees(see(1000, 3.01).angularRadPerS())).isCloseTo(25, within(0.1));
  }

  @Test
  void itDrivesFastThenSlow() {
    assertThat(see(1000, 0)).isEqualTo(new WheelCommand(250, 0));
    assertThat(see(387.5, 0).linearMmPerS()).isCloseTo(212.5, within(1e-9));
    assertThat(see(76, 0).linearMmPerS()).isCloseTo(175, within(0.2));
  }

  @Test
  void itStopsAtTheTargetOrDrivesOn() {
    see(500, 0);
    assertThat(see(60, 0)).isEqualTo(WheelCommand.STOP);
    begin(MotionParameters.builder().stopAtDestination(false).build());
    WheelCommand before = see(100, 0);
    assertThat(see(60, 0)).isEqualTo(before);
    assertThat(see(60, 180)).as("still after it").isEqualTo(before);
    assertThat(automaton.status()).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void anArcLeadsThroughTheTarget() {
    WheelCommand arc = see(600, 20);
    assertThat(automaton.state()).isEqualTo(ARCING);
    assertThat(arc.linearMmPerS()).isEqualTo(200);
    // Chord 600 under twice the bearing.
    double seconds = 2 * Angles.fromDegrees(20) / arc.angularRadPerS();
    Pose end =
        Kinematics.after(
            new Pose(-600, 0, Angles.fromDegrees(-20)),
            arc.linearMmPerS(),
            arc.angularRadPerS(),
            seconds);
    assertThat(end.distanceMm(TARGET)).isLessThan(1e-9);
  }

  @Test
  void aSmallTurnIsAnArcOfHalfTheRadius() {
    see(1000, 0);
    WheelCommand turn = see(1000, -10);
    assertThat(automaton.state()).isEqualTo(SMALLTURN);
    double radiusMm = turn.linearMmPerS() / turn.angularRadPerS();
    double throughTarget = 1000 / (2 * StrictMath.sin(Angles.fromDegrees(10)));
    assertThat(radiusMm).isCloseTo(-throughTarget / 2, within(1e-9));
  }

  @Test
  void noStepOvershootsTheTarget() {
    begin(MotionParameters.builder().goalRadiusMm(1).enableArcing(false).build());
    see(500, 0);
    assertThat(see(9, 0)).isEqualTo(new WheelCommand(9 / 0.06, 0));
    assertThat(automaton.state()).isEqualTo(STRAIGHT);
  }

  @Test
  void turnToEndsWhereTheRobotFacesTheTarget() {
    automaton = MotionAutomaton.turnTo(TARGET, parameters, new Rng(1));
    assertThat(see(10, 40).linearMmPerS()).isZero();
    assertThat(automaton.status()).isEqualTo(MotionFlag.MOVING);
    assertThat(see(10, 2).isStop()).isTrue();
    assertThat(automaton.status()).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void aRobotThatTouchesAtItsStartTurnsAwayButDoesNotPush() {
    begin(
        MotionParameters.DEFAULT.toBuilder()
            .collisionPolicy(CollisionPolicy.STOP_ON_COLLISION)
            .build());
    Pose aside = new Pose(-900, 0, Angles.fromDegrees(-90));
    WheelCommand turn = automaton.step(aside, Bumps.BOTH, nowNs);
    assertThat(turn.linearMmPerS()).isZero();
    assertThat(turn.angularRadPerS()).isPositive();
    assertThat(automaton.status()).isEqualTo(MotionFlag.MOVING);
    automaton.step(new Pose(-900, 0, 0), Bumps.BOTH, nowNs + 60_000_000);
    assertThat(automaton.status()).isEqualTo(MotionFlag.FAIL);
  }
}

package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.body.WheelCommand;
import org.starl.robot.create.CreateHold;
import org.starl.robot.file.Limits;

/** When the wheels of a base may turn. */
class BaseStateTest {

  private static final long MS = 1_000_000;
  private static final WheelCommand FORWARD = new WheelCommand(200, 0);
  private static final Messages.Odometry STILL = new Messages.Odometry(0, null, 0, 0);

  private final BaseState state = new BaseState(new Limits(300, 300, 500, 0.1, 200), 233);

  BaseStateTest() {
    state.received(true);
    hear(0);
  }

  private void hear(long ms) {
    state.odometry(STILL, ms * MS);
    state.gate().fixed(ms * MS, ms * MS);
    state.gate().drive(FORWARD, ms * MS);
  }

  @Test
  void theyTurnWhileEverythingIsHeard() {
    assertThat(state.speeds(100 * MS)).isEqualTo(FORWARD);
  }

  @Test
  void eachSilenceStopsThem() {
    state.gate().drive(FORWARD, 250 * MS);
    assertThat(state.speeds(301 * MS)).isEqualTo(FORWARD);
    assertThat(state.holds(501 * MS))
        .contains(CreateHold.NO_SENSORS, CreateHold.STALE_POSITION)
        .doesNotContain(CreateHold.STALE_COMMAND);
    assertThat(state.holds(551 * MS)).contains(CreateHold.STALE_COMMAND);
    assertThat(state.speeds(551 * MS)).isEqualTo(WheelCommand.STOP);
    hear(560);
    assertThat(state.speeds(561 * MS)).isEqualTo(FORWARD);
  }

  @Test
  void aBaseThatReceivesNothingIsHeld() {
    state.received(false);
    assertThat(state.holds(1)).containsExactly(CreateHold.NO_LINK);
    assertThat(state.speeds(1)).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void aContactStopsThemUntilTheProgramKnows() {
    state.contacts(Contacts.of(true, false, false, false));
    assertThat(state.speeds(1)).isEqualTo(WheelCommand.STOP);
    state.gate().inform();
    state.gate().drive(FORWARD, 2);
    assertThat(state.speeds(2).linearMmPerS()).isZero();
    state.gate().drive(new WheelCommand(-100, 0), 3);
    assertThat(state.speeds(3)).isEqualTo(new WheelCommand(-100, 0));
  }

  @Test
  void noWheelIsFasterThanTheLimit() {
    state.gate().drive(new WheelCommand(250, 1), 1);
    WheelCommand speeds = state.speeds(1);
    assertThat(speeds.rightMmPerS(233)).isLessThanOrEqualTo(300 + 1e-9);
    assertThat(speeds.angularRadPerS() / speeds.linearMmPerS())
        .isCloseTo(1.0 / 250, org.assertj.core.api.Assertions.within(1e-12));
  }

  @Test
  void aBaseThatIsFasterThanAllowedIsToldOnce() {
    assertThat(state.odometry(new Messages.Odometry(0, null, 329, 0), 1)).isNull();
    assertThat(state.odometry(new Messages.Odometry(0, null, 331, 0), 2)).contains("331 mm/s");
    assertThat(state.odometry(new Messages.Odometry(0, null, 332, 0), 3)).isNull();
  }

  @Test
  void aSilentTopicIsNamedOnce() {
    var before = state.holds(0);
    assertThat(state.news(before, 600 * MS, "/bot0/odom"))
        .contains("/bot0/odom: no message for 500 ms: wheels stopped");
    assertThat(state.news(state.holds(600 * MS), 700 * MS, "/bot0/odom")).isEmpty();
    hear(710);
    assertThat(state.news(state.holds(710 * MS), 711 * MS, "/bot0/odom"))
        .containsExactly("/bot0/odom: messages again");
  }
}

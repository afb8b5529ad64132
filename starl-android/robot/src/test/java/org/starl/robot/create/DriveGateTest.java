package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;

/** Each reason to hold the wheels, from its first to its last moment. */
class DriveGateTest {

  private static final long COMMAND_MS = 300;
  private static final long POSITION_MS = 500;
  private static final WheelCommand FORWARDS = new WheelCommand(100, 0);

  private final DriveGate gate = new DriveGate(COMMAND_MS, POSITION_MS);

  @BeforeEach
  void drive() {
    gate.drive(FORWARDS, 0);
    gate.fixed(0, 0);
  }

  @Test
  void aCommandHoldsForItsTimeout() {
    assertThat(gate.holds(COMMAND_MS * NS_PER_MS)).isEmpty();
    assertThat(gate.holds(COMMAND_MS * NS_PER_MS + 1)).containsExactly(CreateHold.STALE_COMMAND);
  }

  @Test
  void aFixHoldsForItsTimeoutFromItsMeasurement() {
    long endNs = POSITION_MS * NS_PER_MS;
    gate.fixed(-NS_PER_MS, NS_PER_MS);
    gate.drive(FORWARDS, endNs);
    assertThat(gate.holds(endNs)).isEmpty();
    assertThat(gate.holds(endNs + 1)).containsExactly(CreateHold.STALE_POSITION);
  }

  /** The clock of the cameras may be ahead. */
  @Test
  void aFixFromTheFutureHoldsForItsTimeoutFromItsArrival() {
    long endNs = POSITION_MS * NS_PER_MS;
    gate.fixed(endNs, 0);
    gate.drive(FORWARDS, endNs);
    assertThat(gate.holds(endNs)).isEmpty();
    assertThat(gate.holds(endNs + 1)).containsExactly(CreateHold.STALE_POSITION);
  }

  @Test
  void afterADoubtOnlyALaterFixCounts() {
    gate.doubted(NS_PER_MS);
    gate.fixed(NS_PER_MS, 2 * NS_PER_MS);
    assertThat(gate.holds(2 * NS_PER_MS)).containsExactly(CreateHold.STALE_POSITION);
    gate.fixed(NS_PER_MS + 1, 2 * NS_PER_MS);
    assertThat(gate.holds(2 * NS_PER_MS)).isEmpty();
  }

  /** The program sees a bump that was over before it was told, and then its end. */
  @Test
  void aShortBumpIsToldAndThenItsEnd() {
    gate.bumped(Bumps.LEFT);
    gate.bumped(Bumps.NONE);
    gate.drive(FORWARDS, 0);
    assertThat(gate.holds(0)).containsExactly(CreateHold.BUMP_UNTOLD);
    assertThat(gate.allowed(gate.holds(0), 235, 500).isStop()).isTrue();
    assertThat(gate.inform()).isEqualTo(Bumps.LEFT);
    assertThat(gate.mustInform()).isTrue();
    assertThat(gate.inform()).isEqualTo(Bumps.NONE);
    assertThat(gate.mustInform()).isFalse();
  }

  @Test
  void anEmergencyStopEndsTheCommandToo() {
    gate.emergencyStop(true);
    assertThat(gate.holds(0)).containsExactly(CreateHold.EMERGENCY_STOP);
    gate.emergencyStop(false);
    assertThat(gate.allowed(gate.holds(0), 235, 500)).isEqualTo(WheelCommand.STOP);
  }
}

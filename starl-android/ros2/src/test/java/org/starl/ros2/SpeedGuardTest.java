package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.body.WheelCommand;

/** The guard stops what is silent or late. */
class SpeedGuardTest {

  private static final long MS = 1_000_000;
  private static final WheelCommand FORWARD = new WheelCommand(200, 0);
  private static final WheelCommand STOP = WheelCommand.STOP;

  private final List<WheelCommand> received = new ArrayList<>();
  private final SpeedGuard guard = new SpeedGuard(received::add, 200);

  @Test
  void aSilentProgramIsStoppedOnce() {
    guard.pass(0, FORWARD, 1 * MS);
    guard.advance(199 * MS);
    assertThat(received).containsExactly(FORWARD);
    guard.advance(200 * MS);
    guard.advance(210 * MS);
    assertThat(received).containsExactly(FORWARD, STOP);
  }

  @Test
  void anOldCommandIsNotExecuted() {
    guard.pass(0, FORWARD, 250 * MS);
    assertThat(received).containsExactly(STOP);
    guard.pass(251 * MS, FORWARD, 252 * MS);
    assertThat(received).containsExactly(STOP, FORWARD);
  }

  @Test
  void theAgeIsThatOfTheNewestCommandNotOfItsArrival() {
    guard.pass(0, FORWARD, 150 * MS);
    guard.advance(201 * MS);
    assertThat(received).containsExactly(FORWARD, STOP);
  }

  @Test
  void afterTheEndNothingIsPassed() {
    guard.pass(0, FORWARD, 1);
    guard.halt();
    guard.pass(2, FORWARD, 3);
    assertThat(received).containsExactly(FORWARD, STOP, STOP, STOP);
  }
}

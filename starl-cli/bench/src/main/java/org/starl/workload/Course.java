package org.starl.workload;

import org.starl.spec.FaultState;
import org.starl.time.Time;

/**
 * When rounds begin. All but the last three are spread over the time in which faults may happen;
 * the last three begin after it. A calm course has three more, which begin when the effects of faults
 * are over, too.
 *
 * @param rounds of each robot, above 0
 * @param busyMs faults are over by then
 */
record Course(int rounds, long busyMs, boolean isCalm) {

  static final int MAX_ROUNDS = 1000;

  /** Rounds that begin after the faults. */
  private static final int LAST = 3;

  /** Maximum time by which a robot's clock is still ahead when the faults are over. */
  private static final long CLOCK_ERROR_MS = 2_000;

  private static final long SETTLE_MS = FaultState.SETTLE_NS / Time.NS_PER_MS;

  Course {
    if (rounds <= 0 || busyMs < 0) {
      throw new IllegalArgumentException(rounds + " rounds in " + busyMs + " ms");
    }
  }

  Course(int rounds, long busyMs) {
    this(rounds, busyMs, false);
  }

  /** Of each robot, with those in a calm world. */
  int allRounds() {
    return isCalm ? rounds + LAST : rounds;
  }

  /** Round {@code number}, from 0, begins no earlier than this by the robot's clock. */
  long beginMs(int number) {
    int early = rounds - LAST;
    long calmMs = number < rounds ? 0 : SETTLE_MS;
    return number < early ? busyMs * number / early : busyMs + CLOCK_ERROR_MS + calmMs;
  }
}

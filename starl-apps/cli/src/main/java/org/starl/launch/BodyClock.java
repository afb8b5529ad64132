package org.starl.launch;

import org.starl.platform.Clock;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/**
 * The clock of a robot with a simulated body in real time. It stands still while a piece of the
 * strand runs, so that an action has one time. The program reads it with {@link #nowNs}; the body
 * is where it is at {@link #shownNs}, the time that was read last. So a command takes effect at the
 * time at which the program gives it, as in the simulator, however long the machine took in
 * between. Strand only.
 *
 * <p>It is also the watchdog of the wheels: if the program does not read it for {@link
 * #WATCHDOG_NS}, the wheels stand from then until the next reading.
 */
final class BodyClock implements Clock {

  /** At 250 mm/s a robot drives at most 50 mm without its program. */
  static final long WATCHDOG_NS = 200_000_000;

  /** What the watchdog does to the wheels. */
  interface Wheels {
    void hold();

    void release();
  }

  private final Clock pieces;
  private final Wheels wheels;
  private long shownNs;
  private long longestPauseNs;

  /**
   * @param pieces shows the time at which the current piece began
   */
  BodyClock(Clock pieces, Wheels wheels) {
    this.pieces = pieces;
    this.wheels = wheels;
    shownNs = pieces.nowNs();
  }

  @Override
  public long nowNs() {
    long nowNs = pieces.nowNs();
    long pauseNs = nowNs - shownNs;
    longestPauseNs = Math.max(longestPauseNs, pauseNs);
    if (pauseNs > WATCHDOG_NS) {
      shownNs += WATCHDOG_NS;
      wheels.hold();
      shownNs = nowNs;
      wheels.release();
    }
    shownNs = nowNs;
    return nowNs;
  }

  /** The time that was read last. */
  long shownNs() {
    return shownNs;
  }

  /** The longest time between two readings so far. */
  long longestPauseNs() {
    return longestPauseNs;
  }

  /** Timers that read the clock before they run an action. */
  Timers reading(Timers timers) {
    return action -> timer(timers, action);
  }

  private Timer timer(Timers timers, Runnable action) {
    return timers.timer(() -> {
      nowNs();
      action.run();
    });
  }
}

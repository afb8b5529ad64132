package org.starl.processes;

import org.starl.platform.Clock;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/**
 * The clock of a robot whose body is simulated in real time. It stands still while a piece of the
 * strand runs, so that an action has one time. The program reads it with {@link #nowNs}; its body is
 * where it is at {@link #shownNs}, the time that was read last. So a command takes effect at the very
 * time that the program knows it by, as in the simulator, however long the machine took in between.
 * Strand only.
 *
 * <p>It is the wheels' watchdog as well: where the program has not read it for {@link #WATCHDOG_NS}, the
 * wheels have stood still from then on.
 */
final class BodyClock implements Clock {

  /** At 250 mm/s a robot drives 50 mm blind at most. */
  static final long WATCHDOG_NS = 200_000_000;

  /** The wheels, as a watchdog sees them. */
  interface Wheels {
    void hold();

    void letGo();
  }

  private final Clock pieces;
  private final Wheels wheels;
  private long shownNs;
  private long longestSilenceNs;

  /**
   * @param pieces shows when the piece that runs has begun
   */
  BodyClock(Clock pieces, Wheels wheels) {
    this.pieces = pieces;
    this.wheels = wheels;
    shownNs = pieces.nowNs();
  }

  @Override
  public long nowNs() {
    long nowNs = pieces.nowNs();
    long silenceNs = nowNs - shownNs;
    longestSilenceNs = Math.max(longestSilenceNs, silenceNs);
    if (silenceNs > WATCHDOG_NS) {
      shownNs += WATCHDOG_NS;
      wheels.hold();
      shownNs = nowNs;
      wheels.letGo();
    }
    shownNs = nowNs;
    return nowNs;
  }

  /** What was read last. */
  long shownNs() {
    return shownNs;
  }

  /** The longest time between two readings so far. */
  long longestSilenceNs() {
    return longestSilenceNs;
  }

  /** Timers whose actions find the time read. */
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

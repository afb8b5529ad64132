package org.starl.launch;

import java.util.function.DoubleConsumer;
import org.starl.platform.Clock;
import org.starl.platform.Timers;
import org.starl.time.Time;

/**
 * The clock of a robot with a simulated body in real time. It stands still while a piece of the
 * strand runs, so that an action has one time. The program reads it with {@link #nowNs}; the body
 * is simulated until {@link #shownNs}, the time of the last reading. So a command takes effect at
 * the time at which the program gives it, as in the simulator, however slow the machine is. Strand
 * only.
 *
 * <p>It is also the watchdog of the wheels: if the program does not read it for {@link
 * #WATCHDOG_NS}, the wheels stand from then until the next reading.
 */
final class BodyClock implements Clock {

  /** At 250 mm/s a robot drives at most 50 mm without its program. */
  static final long WATCHDOG_NS = 200 * Time.NS_PER_MS;

  private final Clock pieces;
  private final DoubleConsumer wheelFactor;
  private long shownNs;
  private long longestPauseNs;

  /**
   * @param pieces shows the time at which the current piece began
   * @param wheelFactor scales the wheels' speeds: 0 stops them, 1 releases them
   */
  BodyClock(Clock pieces, DoubleConsumer wheelFactor) {
    this.pieces = pieces;
    this.wheelFactor = wheelFactor;
    shownNs = pieces.nowNs();
  }

  @Override
  public long nowNs() {
    long nowNs = pieces.nowNs();
    long pauseNs = nowNs - shownNs;
    longestPauseNs = Math.max(longestPauseNs, pauseNs);
    if (pauseNs > WATCHDOG_NS) {
      shownNs += WATCHDOG_NS;
      wheelFactor.accept(0);
      shownNs = nowNs;
      wheelFactor.accept(1);
    }
    shownNs = nowNs;
    return nowNs;
  }

  /** The time of the last reading. */
  long shownNs() {
    return shownNs;
  }

  /** The longest time between two readings so far. */
  long longestPauseNs() {
    return longestPauseNs;
  }

  /** Timers that read the clock before they run an action. */
  Timers reading(Timers timers) {
    return action ->
        timers.timer(() -> {
          nowNs();
          action.run();
        });
  }
}

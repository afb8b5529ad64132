package org.starl.ros2;

import static org.starl.time.Time.NS_PER_MS;

import java.util.function.Consumer;
import org.starl.body.WheelCommand;

/**
 * Passes speeds to a base as long as they are not too old, and stops it when the program is silent. Each
 * speed has the time at which the program gave it, so one that was held up is not executed late. From
 * any thread.
 */
final class SpeedGuard {

  private static final int STOP_COPIES = 3;

  private final Consumer<WheelCommand> base;
  private final long validNs;
  private boolean mayTurn;
  private boolean isHalted;
  private long lastSentNs = Long.MIN_VALUE;

  /** @param validMs for how many ms a command is executed */
  SpeedGuard(Consumer<WheelCommand> base, long validMs) {
    this.base = base;
    validNs = validMs * NS_PER_MS;
  }

  /** The program's speeds of {@code sentNs}. */
  synchronized void pass(long sentNs, WheelCommand speeds, long nowNs) {
    if (isHalted) {
      return;
    }
    if (nowNs - sentNs >= validNs) {
      stop();
      return;
    }
    lastSentNs = Math.max(lastSentNs, sentNs);
    mayTurn = !speeds.isStop();
    base.accept(speeds);
  }

  /** Call it every few ms: stops the wheels of a silent program. */
  synchronized void advance(long nowNs) {
    if (mayTurn && nowNs - lastSentNs >= validNs) {
      stop();
    }
  }

  /** Stops the wheels for good. */
  synchronized void halt() {
    isHalted = true;
    for (int i = 0; i < STOP_COPIES; i++) {
      stop();
    }
  }

  private void stop() {
    mayTurn = false;
    base.accept(WheelCommand.STOP);
  }
}

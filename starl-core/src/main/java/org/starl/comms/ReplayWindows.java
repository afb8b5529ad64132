package org.starl.comms;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * Which transmissions of which genuine senders have arrived, so that each counts once. Of a sender's
 * incarnation the {@link #WINDOW} highest counts are told apart; older ones are refused. Pure.
 *
 * <p>It does not outlive a restart of this robot, who then takes old recordings once more: to what
 * lies above they are messages that were doubled and late, which they bear anyway.
 */
final class ReplayWindows {

  static final int WINDOW = 1024;

  // Looked up only, never iterated. Its keys hold the deployment's key, so nobody can fill it.
  private final Map<RobotId, Window> windows = new HashMap<>();

  /** Takes a transmission in; null if it is the first time that it arrives. */
  @Nullable DropReason admit(RobotId from, int boot, long count) {
    Window window = windows.get(from);
    if (window == null || boot > window.boot) {
      window = new Window(boot);
      windows.put(from, window);
    }
    if (boot < window.boot) {
      return DropReason.DEAD_SENDER;
    }
    return window.isFirst(count) ? null : DropReason.REPLAYED;
  }

  private static final class Window {
    private final int boot;
    private final long[] seen = new long[WINDOW / Long.SIZE];
    private long highest;

    Window(int boot) {
      this.boot = boot;
    }

    boolean isFirst(long count) {
      if (count <= highest - WINDOW || count <= 0) {
        return false;
      }
      for (long skipped = Math.max(highest, count - WINDOW) + 1; skipped <= count; skipped++) {
        seen[word(skipped)] &= ~bit(skipped);
      }
      highest = Math.max(highest, count);
      boolean first = (seen[word(count)] & bit(count)) == 0;
      seen[word(count)] |= bit(count);
      return first;
    }

    private static int word(long count) {
      return (int) (count & (WINDOW - 1)) / Long.SIZE;
    }

    private static long bit(long count) {
      return 1L << count;
    }
  }
}

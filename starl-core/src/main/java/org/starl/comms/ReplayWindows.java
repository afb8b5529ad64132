package org.starl.comms;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * Which transmissions of which authenticated senders have arrived, so that each is accepted once.
 * For each sender's incarnation the {@link #WINDOW} highest counts are tracked individually; older
 * ones are dropped. Pure.
 *
 * <p>This state is lost when this robot restarts, and old recordings are accepted once more: to the
 * layers above they are duplicated and delayed messages, which they tolerate anyway.
 */
final class ReplayWindows {

  static final int WINDOW = 1024;

  // Never iterated. Only holders of the deployment's key can add entries, so an attacker cannot
  // fill it.
  private final Map<RobotId, Sender> senders = new HashMap<>();

  /**
   * Takes in a transmission.
   *
   * @return why to drop it, or null if it arrives for the first time
   */
  @Nullable DropReason admit(RobotId from, int boot, long count) {
    Sender sender = senders.get(from);
    if (sender == null || boot > sender.boot) {
      sender = new Sender(boot, new SlidingWindow(WINDOW));
      senders.put(from, sender);
    }
    if (boot < sender.boot) {
      return DropReason.DEAD_SENDER;
    }
    if (sender.arrived.isTooOld(count) || sender.arrived.contains(count)) {
      return DropReason.REPLAYED;
    }
    sender.arrived.add(count);
    return null;
  }

  private record Sender(int boot, SlidingWindow arrived) {}
}

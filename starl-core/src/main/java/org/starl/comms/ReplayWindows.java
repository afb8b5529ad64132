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

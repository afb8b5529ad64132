package org.starl.comms;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * The receiver's side of reliable unicast: which messages of which incarnation of which sender were
 * handled. Pure: no clock, no radio. Each sender numbers its reliable messages to this robot 1, 2,
 * 3, ... The {@link #WINDOW} highest numbers are tracked individually; older messages are dropped,
 * because it is unknown whether they were handled. So each message is handled at most once.
 *
 * <p>A sender's highest boot number is kept for the whole run, so that messages of its earlier
 * incarnations are dropped. This state is lost when this robot restarts.
 */
final class InboundWindows {

  /** The sender's pending messages are never further apart than this: see {@link OutboundQueue}. */
  static final int WINDOW = 256;

  /** Bounds the memory, about 150 bytes per sender; messages of further senders are dropped. */
  static final int MAX_SENDERS = 65_536;

  // Never iterated, so the order of hashes has no effect.
  private final Map<RobotId, Sender> senders = new HashMap<>();

  /**
   * Records a message of an incarnation of {@code from}.
   *
   * @return why to drop it, or null unless the incarnation has a successor
   */
  @Nullable DropReason admit(RobotId from, int boot) {
    // A first incarnation has no predecessor, so it needs no entry.
    Sender sender = senders.isEmpty() ? null : senders.get(from);
    if (sender == null) {
      return boot == 1 || remember(from, boot) != null ? null : DropReason.TOO_MANY_SENDERS;
    }
    if (boot < sender.boot) {
      return DropReason.DEAD_SENDER;
    }
    if (boot > sender.boot) {
      sender.restart(boot);
    }
    return null;
  }

  /** Why to drop message {@code order} of an admitted incarnation, or null to handle it. */
  @Nullable DropReason refusal(RobotId from, long order) {
    Sender sender = senders.get(from);
    if (sender == null) {
      return senders.size() < MAX_SENDERS ? null : DropReason.TOO_MANY_SENDERS;
    }
    if (sender.handled.isTooOld(order)) {
      return DropReason.TOO_OLD;
    }
    return sender.handled.contains(order) ? DropReason.DUPLICATE : null;
  }

  /** Marks message {@code order}, which is not refused, as handled. */
  void handle(RobotId from, int boot, long order) {
    Sender sender = senders.get(from);
    if (sender == null) {
      sender = remember(from, boot);
    }
    if (sender == null) {
      throw new IllegalStateException("message " + order + " of " + from + " was refused");
    }
    sender.handled.add(order);
  }

  int size() {
    return senders.size();
  }

  private @Nullable Sender remember(RobotId from, int boot) {
    if (senders.size() >= MAX_SENDERS) {
      return null;
    }
    Sender sender = new Sender(boot);
    senders.put(from, sender);
    return sender;
  }

  private static final class Sender {
    private int boot;
    private SlidingWindow handled = new SlidingWindow(WINDOW);

    Sender(int boot) {
      this.boot = boot;
    }

    void restart(int newBoot) {
      boot = newBoot;
      handled = new SlidingWindow(WINDOW);
    }
  }
}

package org.starl.comms;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * The receiver's side of reliable unicast: which messages of which incarnation of which sender were
 * handled. Pure: no clock, no radio. Each sender numbers its reliable messages to this robot 1, 2, 3
 * ...; of these the {@link #WINDOW} highest are told apart, and what is older is refused, since
 * nobody knows any more whether it was handled. So each is handled at most once.
 *
 * <p>A sender's highest boot number is kept for ever, so that its dead incarnations stay dead; what
 * is kept does not outlive this robot's own restart.
 */
final class InboundWindows {

  /** The sender never has messages further apart than this under way: {@link OutboundQueue}. */
  static final int WINDOW = 256;

  /** A bound to memory, about 150 bytes each; those beyond are refused. */
  static final int MAX_SENDERS = 65_536;

  // Looked up only, never iterated.
  private final Map<RobotId, Sender> senders = new HashMap<>();

  /** Learns that an incarnation of {@code from} lives; null unless it has a successor. */
  @Nullable DropReason admit(RobotId from, int boot) {
    // First incarnations have no predecessors, and need no entry to be told from them.
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

  /** Why not to handle message {@code order} of an admitted incarnation, or null to handle it. */
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

  /** Message {@code order}, which is not refused, is handled now. */
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

package org.starl.comms;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * The sender's side of reliable unicast. Pure: the caller passes calls, acknowledgements and the
 * time, and receives transmissions and settled receipts. Each message is retransmitted until it is
 * acknowledged, its retries are used up or its deadline has passed.
 *
 * <p>Messages to one receiver are independent, with one exception: a message waits while another
 * that is {@link InboundWindows#WINDOW} or more older is unsettled, because the receiver could no
 * longer tell that one from a duplicate.
 *
 * @param <P> the content of a message
 */
final class OutboundQueue<P> {

  /** Transmits messages. Receipts report their own settlement. */
  @FunctionalInterface
  interface Output<P> {
    void transmit(Outgoing<P> message);
  }

  private final Output<P> output;
  private final PriorityQueue<Outgoing<P>> byDue = new PriorityQueue<>(1, Outgoing::compareByDue);
  private final Map<RobotId, Lane<P>> lanes = new TreeMap<>();

  OutboundQueue(Output<P> output) {
    this.output = output;
  }

  /** The order of the next message to {@code to}. */
  long nextOrder(RobotId to) {
    Lane<P> lane = lanes.get(to);
    return lane == null ? 1 : lane.lastOrder + 1;
  }

  Outgoing<P> send(RobotId to, P content, Reliability reliability, long nowNs) {
    Lane<P> lane = lane(to);
    lane.lastOrder++;
    Outgoing<P> message = new Outgoing<>(to, lane.lastOrder, content, reliability, nowNs);
    lane.heldBack.add(message);
    byDue.add(message);
    transmitHeldBack(lane, nowNs);
    return message;
  }

  /**
   * Handles an acknowledgement: the receiver has handled message {@code order}.
   *
   * @return whether the message was unsettled
   */
  boolean acknowledged(RobotId from, long order, long nowNs) {
    Lane<P> lane = lanes.get(from);
    if (lane == null) {
      return false;
    }
    for (Outgoing<P> message : lane.window) {
      if (message.order == order && !message.isSettled()) {
        settle(lane, message, true, nowNs);
        return true;
      }
    }
    return false;
  }

  /** Retransmits or gives up the messages that are due. */
  void advance(long nowNs) {
    Outgoing<P> message = byDue.peek();
    while (message != null && message.dueNs() <= nowNs) {
      if (message.isExhausted(nowNs)) {
        settle(lane(message.to), message, false, nowNs);
      } else {
        transmit(message, nowNs);
      }
      message = byDue.peek();
    }
  }

  /** Gives up every message whose content matches {@code which}. */
  void fail(Predicate<? super P> which, long nowNs) {
    List<Outgoing<P>> doomed = new ArrayList<>();
    for (Lane<P> lane : lanes.values()) {
      lane.addPending(which, doomed);
    }
    for (Outgoing<P> message : doomed) {
      message.settle(false);
      byDue.remove(message);
    }
    for (Lane<P> lane : lanes.values()) {
      transmitHeldBack(lane, nowNs);
    }
    doomed.forEach(Outgoing::runActions);
  }

  /** The time of the next due message, or {@code Long.MAX_VALUE}. */
  long nextDueNs() {
    Outgoing<P> first = byDue.peek();
    return first == null ? Long.MAX_VALUE : first.dueNs();
  }

  private Lane<P> lane(RobotId to) {
    return lanes.computeIfAbsent(to, any -> new Lane<>());
  }

  private void transmit(Outgoing<P> message, long nowNs) {
    byDue.remove(message);
    message.transmitted(nowNs);
    byDue.add(message);
    output.transmit(message);
  }

  // The receipt's actions run last, because they may send again.
  private void settle(Lane<P> lane, Outgoing<P> message, boolean delivered, long nowNs) {
    message.settle(delivered);
    byDue.remove(message);
    transmitHeldBack(lane, nowNs);
    message.runActions();
  }

  private void transmitHeldBack(Lane<P> lane, long nowNs) {
    Outgoing<P> next = lane.pollTransmittable();
    while (next != null) {
      if (!next.isExhausted(nowNs)) { // else it is given up: it is due
        transmit(next, nowNs);
      }
      next = lane.pollTransmittable();
    }
  }

  /** The messages to one receiver. */
  private static final class Lane<P> {
    private long lastOrder;

    /** Transmitted messages, the oldest unsettled one first; settled ones may follow it. */
    private final ArrayDeque<Outgoing<P>> window = new ArrayDeque<>(2);

    private final ArrayDeque<Outgoing<P>> heldBack = new ArrayDeque<>(2);

    @Nullable Outgoing<P> pollTransmittable() {
      dropSettled(window);
      dropSettled(heldBack);
      Outgoing<P> oldest = window.peek();
      Outgoing<P> next = heldBack.peek();
      if (next == null || (oldest != null && next.order >= oldest.order + InboundWindows.WINDOW)) {
        return null;
      }
      heldBack.poll();
      window.add(next);
      return next;
    }

    void addPending(Predicate<? super P> which, List<Outgoing<P>> list) {
      for (ArrayDeque<Outgoing<P>> queue : List.of(window, heldBack)) {
        for (Outgoing<P> message : queue) {
          if (!message.isSettled() && which.test(message.content)) {
            list.add(message);
          }
        }
      }
    }

    private static void dropSettled(ArrayDeque<? extends Outgoing<?>> queue) {
      Outgoing<?> first = queue.peek();
      while (first != null && first.isSettled()) {
        queue.poll();
        first = queue.peek();
      }
    }
  }
}

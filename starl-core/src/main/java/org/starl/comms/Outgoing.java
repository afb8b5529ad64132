package org.starl.comms;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.List;
import org.starl.id.RobotId;

/** A reliable message on the sender's side, and its receipt. */
final class Outgoing<P> implements Receipt {

  /** About 30 years, so that no sum of times overflows. */
  private static final long MAX_MS = 1_000_000_000_000L;

  private enum State {
    PENDING,
    DELIVERED,
    FAILED
  }

  final RobotId to;

  /** Its number among the sender's reliable messages to {@link #to}, from 1. */
  final long order;

  final P content;
  final long deadlineNs;
  private final Reliability reliability;
  private final List<Runnable> actions = new ArrayList<>(0);
  private State state = State.PENDING;
  private long waitNs;
  private long dueNs;
  private int transmissions;

  Outgoing(RobotId to, long order, P content, Reliability reliability, long nowNs) {
    this.to = to;
    this.order = order;
    this.content = content;
    this.reliability = reliability;
    this.deadlineNs = nowNs + ns(reliability.deadlineMs());
    this.dueNs = deadlineNs;
    this.waitNs = ns(reliability.firstRetryMs());
  }

  /** The time of the next retransmission, or of giving up. */
  long dueNs() {
    return dueNs;
  }

  boolean isExhausted(long nowNs) {
    return nowNs >= deadlineNs || transmissions > reliability.maxRetries();
  }

  void transmitted(long nowNs) {
    transmissions++;
    dueNs = Math.min(nowNs + waitNs, deadlineNs);
    waitNs = Math.min((long) (waitNs * reliability.backoff()), ns(reliability.maxWaitMs()));
  }

  void settle(boolean delivered) {
    state = delivered ? State.DELIVERED : State.FAILED;
  }

  void runActions() {
    List<Runnable> todo = List.copyOf(actions);
    actions.clear();
    todo.forEach(Runnable::run);
  }

  @Override
  public boolean isDelivered() {
    return state == State.DELIVERED;
  }

  @Override
  public boolean isFailed() {
    return state == State.FAILED;
  }

  @Override
  public void whenSettled(Runnable action) {
    if (isSettled()) {
      action.run();
    } else {
      actions.add(action);
    }
  }

  /** Orders by due time; of equal ones by receiver and order, so that the order is total. */
  static int compareByDue(Outgoing<?> a, Outgoing<?> b) {
    int byDue = Long.compare(a.dueNs, b.dueNs);
    if (byDue != 0) {
      return byDue;
    }
    int byReceiver = a.to.compareTo(b.to);
    return byReceiver != 0 ? byReceiver : Long.compare(a.order, b.order);
  }

  private static long ns(long ms) {
    return Math.min(ms, MAX_MS) * NS_PER_MS;
  }
}

package org.starl.comms;

import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/** Joins an {@link OutboundQueue} to the robot's clock and to one timer. */
final class ReliableSender {

  private final Clock clock;
  private final Timer timer;
  private final OutboundQueue<RetainedMessage> queue;
  private long timerNs = Long.MAX_VALUE;

  ReliableSender(Clock clock, Timers timers, OutboundQueue.Output<RetainedMessage> output) {
    this.clock = clock;
    this.timer = timers.timer(this::advance);
    this.queue = new OutboundQueue<>(output);
  }

  /** The order that the next message to {@code to} will have. */
  long nextOrder(RobotId to) {
    return queue.nextOrder(to);
  }

  Receipt send(RobotId to, RetainedMessage message, Reliability reliability) {
    Receipt receipt = queue.send(to, message, reliability, clock.nowNs());
    setTimer();
    return receipt;
  }

  /** Whether it was news that {@code from} has handled message {@code order}. */
  boolean acknowledged(RobotId from, long order) {
    boolean isNews = queue.acknowledged(from, order, clock.nowNs());
    setTimer();
    return isNews;
  }

  /** Gives up what {@code endpoint} has under way. */
  void fail(OpenEndpoint<?> endpoint) {
    queue.fail(message -> message.endpoint == endpoint, clock.nowNs());
    setTimer();
  }

  private void advance() {
    timerNs = Long.MAX_VALUE;
    queue.advance(clock.nowNs());
    setTimer();
  }

  private void setTimer() {
    long dueNs = queue.nextDueNs();
    if (dueNs != timerNs) {
      timerNs = dueNs;
      if (dueNs == Long.MAX_VALUE) {
        timer.cancel();
      } else {
        timer.set(dueNs);
      }
    }
  }
}

package org.starl.comms;

import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/** Runs an {@link OutboundQueue} on the robot's clock and one timer. */
final class ReliableSender {

  private final Clock clock;
  private final Timer timer;
  private final OutboundQueue<RetainedMessage> queue;

  ReliableSender(Clock clock, Timers timers, OutboundQueue.Output<RetainedMessage> output) {
    this.clock = clock;
    this.timer = timers.timer(this::advance);
    this.queue = new OutboundQueue<>(output);
  }

  /** The order of the next message to {@code to}. */
  long nextOrder(RobotId to) {
    return queue.nextOrder(to);
  }

  Receipt send(RobotId to, RetainedMessage message, Reliability reliability) {
    Receipt receipt = queue.send(to, message, reliability, clock.nowNs());
    setTimer();
    return receipt;
  }

  /**
   * Handles an acknowledgement of message {@code order}.
   *
   * @return whether the message was unsettled
   */
  boolean acknowledged(RobotId from, long order) {
    boolean isNew = queue.acknowledged(from, order, clock.nowNs());
    setTimer();
    return isNew;
  }

  /** Gives up all pending messages of {@code endpoint}. */
  void fail(OpenEndpoint<?> endpoint) {
    queue.fail(message -> message.endpoint == endpoint, clock.nowNs());
    setTimer();
  }

  private void advance() {
    queue.advance(clock.nowNs());
    setTimer();
  }

  private void setTimer() {
    timer.set(queue.nextDueNs());
  }
}

package org.starl.comms;

import org.starl.id.RobotId;

/**
 * This robot's end of a channel. Strand only. A message to this robot itself arrives too, in a
 * later piece of the strand, through the codec but without the radio.
 *
 * <p>A message that does not fit a datagram ({@link org.starl.platform.Radio#MAX_BYTES}, header
 * included) causes an {@link IllegalArgumentException}; sending on a closed endpoint, an {@link
 * IllegalStateException}.
 */
public interface Endpoint<T> {

  /** Sends best effort: the message may be lost, delayed, duplicated or reordered. */
  void send(RobotId to, T message);

  /** Sends best effort to every robot in range except this one. */
  void broadcast(T message);

  /**
   * Retransmits until the receiver has handled the message, exactly once, or {@link
   * Receipt#isFailed} reports that it may not have; with the default {@link Reliability}.
   */
  Receipt sendReliably(RobotId to, T message);

  Receipt sendReliably(RobotId to, T message, Reliability reliability);

  /**
   * Closes the endpoint: it receives nothing more. Pending receipts fail, and their actions run
   * inside this call.
   */
  void close();

  /** Receives a channel's messages, on the strand. */
  @FunctionalInterface
  interface Handler<T> {
    void received(RobotId from, T message);
  }
}

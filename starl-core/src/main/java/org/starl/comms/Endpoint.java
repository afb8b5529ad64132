package org.starl.comms;

import org.starl.id.RobotId;

/**
 * This robot's end of a channel. Strand only. What is sent to this robot itself arrives as well, in
 * a later piece of the strand, without the radio, through the codec.
 *
 * <p>A message that does not fit a datagram ({@link org.starl.platform.Radio#MAX_BYTES}, header
 * included) is an {@link IllegalArgumentException}; sending on a closed endpoint is an {@link
 * IllegalStateException}.
 */
public interface Endpoint<T> {

  /** Sends best effort: the message may be lost, late, doubled or overtaken. */
  void send(RobotId to, T message);

  /** Sends best effort to every robot in reach except this one. */
  void broadcast(T message);

  /**
   * Sends until the other end has handled it, once, or {@link Receipt#isFailed} tells that it may
   * not have; with the default {@link Reliability}.
   */
  Receipt sendReliably(RobotId to, T message);

  Receipt sendReliably(RobotId to, T message, Reliability reliability);

  /** Hears nothing more; receipts under way fail, and their actions run inside this call. */
  void close();

  /** Takes a channel's messages, on the strand. */
  @FunctionalInterface
  interface Handler<T> {
    void received(RobotId from, T message);
  }
}

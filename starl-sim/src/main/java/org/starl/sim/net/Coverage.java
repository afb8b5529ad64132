package org.starl.sim.net;

/**
 * Decides which robots a robot's radio reaches, by their numbers ({@link SimNetwork#number}). It
 * is asked when a datagram is sent.
 */
public interface Coverage {

  /**
   * Why a datagram does not reach a robot, one word for the trace; empty if it does.
   *
   * @param from number of the sender, and {@code to} that of the recipient
   */
  String obstacle(int from, int to);

  /** Sets {@code hearers} to the robots that a broadcast of {@code from} reaches. */
  void find(int from, Hearers hearers);
}

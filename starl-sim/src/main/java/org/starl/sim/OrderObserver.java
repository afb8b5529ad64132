package org.starl.sim;

import org.starl.sim.net.CopyWatch;

/**
 * Also observes in which order the kernel runs the robots' events, and when each copy of a datagram
 * arrives. A run has at most one. It has no effect on the run.
 */
public interface OrderObserver extends SimObserver, CopyWatch {

  /**
   * Called after each event of the kernel.
   *
   * @param robot the robot on which the event ran; empty for an event of the world
   */
  void ran(long timeNs, String robot);
}

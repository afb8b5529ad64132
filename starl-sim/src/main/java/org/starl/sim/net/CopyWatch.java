package org.starl.sim.net;

/** Is told of each copy of a datagram that a robot sends to one in range; has no effect on it. */
@FunctionalInterface
public interface CopyWatch {

  /** The delay of a copy that is lost. */
  long LOST = -1;

  /**
   * Called when the copy is sent.
   *
   * @param delayNs time until it arrives, if its recipient is there then; or {@link #LOST}
   */
  void sent(Transmission copy, long delayNs);
}

package org.starl.comms;

/** The objects that a received message reads, for a simulator that loads them into the cache. */
public final class ReceivePath {

  private ReceivePath() {}

  /** The objects of a robot whose app has opened its first endpoint. */
  public static Object[] of(Comms comms) {
    return comms.receiver().path();
  }
}

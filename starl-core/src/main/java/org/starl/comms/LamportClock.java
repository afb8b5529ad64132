package org.starl.comms;

/**
 * A logical clock (Lamport, "Time, clocks, and the ordering of events in a distributed system", CACM
 * 1978): one a robot, carried by every message of every layer. Strand only.
 */
public final class LamportClock {

  private long time;

  /** The clock's value. */
  public long now() {
    return time;
  }

  /** A value above all that this robot has seen. */
  public long tick() {
    time++;
    return time;
  }

  /** Learns that somebody has seen {@code other}. */
  public void witness(long other) {
    if (other > time) {
      time = other;
    }
  }
}

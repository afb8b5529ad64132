package org.starl.comms;

/**
 * A logical clock (Lamport, "Time, clocks, and the ordering of events in a distributed system",
 * CACM 1978): one per robot, carried by every message. Strand only.
 */
public final class LamportClock {

  private long time;

  /** The current value. */
  public long now() {
    return time;
  }

  /**
   * Increments the clock.
   *
   * @return the new value, above all values that this robot has seen
   */
  public long tick() {
    time++;
    return time;
  }

  /** Advances the clock to {@code other} if that is larger. */
  public void advanceTo(long other) {
    if (other > time) {
      time = other;
    }
  }
}

package org.starl.primitives.registration;

/**
 * Progress of spreading the latest view that this robot has decided. A leaving robot stays until all
 * receivers have the view, or for a bounded time: no other robot may know the view yet.
 */
final class ViewBroadcast {

  private final long boundNs;
  private long number;
  private int remaining;
  private long giveUpAtNs = Long.MAX_VALUE;

  ViewBroadcast(long boundNs) {
    this.boundNs = boundNs;
  }

  void begin(long aNumber, int receivers, long nowNs) {
    number = aNumber;
    remaining = receivers;
    giveUpAtNs = receivers == 0 ? Long.MAX_VALUE : nowNs + boundNs;
  }

  /** One receiver has the view {@code itsNumber}, or is given up. */
  void settled(long itsNumber) {
    if (itsNumber == number && remaining > 0) {
      remaining--;
      giveUpAtNs = remaining == 0 ? Long.MAX_VALUE : giveUpAtNs;
    }
  }

  boolean isDone() {
    return remaining == 0;
  }

  long wakeAtNs() {
    return giveUpAtNs;
  }

  void timer(long nowNs) {
    if (nowNs >= giveUpAtNs) {
      remaining = 0;
      giveUpAtNs = Long.MAX_VALUE;
    }
  }
}

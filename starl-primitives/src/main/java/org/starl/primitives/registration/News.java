package org.starl.primitives.registration;

/**
 * How far the latest view that this robot has decided is on its way to those concerned. Who leaves
 * stays until it has arrived, or for a bounded time: nobody else may know of it yet.
 */
final class News {

  private final long boundNs;
  private long number;
  private int underWay;
  private long giveUpAtNs = Long.MAX_VALUE;

  News(long boundNs) {
    this.boundNs = boundNs;
  }

  void begin(long aNumber, int receivers, long nowNs) {
    number = aNumber;
    underWay = receivers;
    giveUpAtNs = receivers == 0 ? Long.MAX_VALUE : nowNs + boundNs;
  }

  /** One receiver has the news of {@code itsNumber}, or is given up. */
  void settled(long itsNumber) {
    if (itsNumber == number && underWay > 0) {
      underWay--;
      giveUpAtNs = underWay == 0 ? Long.MAX_VALUE : giveUpAtNs;
    }
  }

  boolean isOut() {
    return underWay == 0;
  }

  long wakeAtNs() {
    return giveUpAtNs;
  }

  void timer(long nowNs) {
    if (nowNs >= giveUpAtNs) {
      underWay = 0;
      giveUpAtNs = Long.MAX_VALUE;
    }
  }
}

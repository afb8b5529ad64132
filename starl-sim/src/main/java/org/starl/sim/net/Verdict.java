package org.starl.sim.net;

/** What a {@link LinkRule} says about a copy of a datagram. */
public sealed interface Verdict {

  /** No opinion: the next rule decides, after the last one the base loss and delay. */
  Verdict PASS = new Pass();

  static Verdict drop(String why) {
    return new Drop(why);
  }

  static Verdict deliverAfter(long delayNs) {
    return new Deliver(new long[] {delayNs});
  }

  /** Delivers it several times, once after each delay. */
  static Verdict duplicate(long... delaysNs) {
    return new Deliver(delaysNs.clone());
  }

  /** See {@link #PASS}. */
  record Pass() implements Verdict {}

  /**
   * It arrives nowhere.
   *
   * @param why one word for the trace: {@code partition}, {@code range}, ...
   */
  record Drop(String why) implements Verdict {}

  /** It arrives after this delay, and again after each further one. */
  final class Deliver implements Verdict {
    private final long[] delaysNs;

    private Deliver(long[] delaysNs) {
      if (delaysNs.length == 0) {
        throw new IllegalArgumentException("no delay: expected at least one");
      }
      for (long delayNs : delaysNs) {
        if (delayNs < 0) {
          throw new IllegalArgumentException("delay " + delayNs + " ns: expected at least 0");
        }
      }
      this.delaysNs = delaysNs;
    }

    int copies() {
      return delaysNs.length;
    }

    long delayNs(int copy) {
      return delaysNs[copy];
    }
  }
}

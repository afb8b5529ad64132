package org.starl.sim.net;

/** The decision of a {@link LinkRule} about a copy of a datagram. */
public sealed interface Verdict {

  /** The next rule decides; after the last one, the base loss and delay. */
  Verdict PASS = new Pass();

  static Verdict drop(String why) {
    return new Drop(why);
  }

  /** The next rule decides; if it delivers the copy, the copy arrives {@code extraNs} later. */
  static Verdict later(long extraNs) {
    return new Later(extraNs);
  }

  /** The next rule decides; if the copy arrives, it arrives again {@code afterNs} later. */
  static Verdict again(long afterNs) {
    return new Again(afterNs);
  }

  /**
   * The base loss and delay do not apply: the copy arrives {@code delayNs} after it was sent, and
   * later by what the other rules add.
   */
  static Verdict exactly(long delayNs) {
    return new Exactly(delayNs);
  }

  /** See {@link #PASS}. */
  record Pass() implements Verdict {}

  /** See {@link #later}. */
  record Later(long extraNs) implements Verdict {
    public Later {
      requireDelay(extraNs);
    }
  }

  /** See {@link #again}. */
  record Again(long afterNs) implements Verdict {
    public Again {
      requireDelay(afterNs);
    }
  }

  /** See {@link #exactly}. */
  record Exactly(long delayNs) implements Verdict {
    public Exactly {
      requireDelay(delayNs);
    }
  }

  private static void requireDelay(long delayNs) {
    if (delayNs < 0) {
      throw new IllegalArgumentException("delay " + delayNs + " ns: expected at least 0");
    }
  }

  /**
   * The copy is dropped.
   *
   * @param why one word for the trace: {@code partition}, {@code range}, ...
   */
  record Drop(String why) implements Verdict {}
}

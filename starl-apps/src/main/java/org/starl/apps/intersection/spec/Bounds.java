package org.starl.apps.intersection.spec;

import org.starl.apps.intersection.logic.Crossing;
import org.starl.primitives.mutex.MutexBounds;
import org.starl.primitives.mutex.MutexTimes;

/**
 * The times within which progress is owed, in ns. They are generous: they tell a run in which somebody
 * waits for ever from one in which somebody waits long.
 *
 * @param deltaNs a message that is repeated until it is answered arrives within this time
 * @param cars how many are there at most at a time
 * @param places how many places of an arm cars hold before they are in the arrival zone; 0 if they
 *     begin there
 */
public record Bounds(long deltaNs, int cars, int places) {

  private static final long NS_PER_MS = 1_000_000;

  // At most, for one car that has its turn: to join the view and be granted; to drive 3.5 m at the
  // lowest straight speed; to turn three times by a right angle at the lowest turning speed and
  // settle.
  private static final long NETWORK_NS = 15_000_000_000L;
  private static final long DRIVE_NS = 20_000_000_000L;
  private static final long TURNS_NS = 15_000_000_000L;
  // And once: until the last debris is cleared away.
  private static final long DEBRIS_NS = 30_000_000_000L;

  /** How many cars a car at the head of its arm can find before it: three others, four crossing. */
  private static final int TURNS_BEFORE = 7;

  /** Somebody may have left, and the news of it are asked for every so often. */
  private static final long NEWS_NS = 2_000_000_000;

  private static final long DAY_NS = 24L * 3600 * 1_000_000_000;

  /** A message that is lost so often in a row is not expected in all campaigns together. */
  private static final double NEVER = 1e-13;

  public Bounds {
    if (deltaNs < 0 || cars < 0 || places < 0 || places >= Crossing.PLACES) {
      throw new IllegalArgumentException(
          "bounds of " + cars + " cars, " + places + " places, delta " + deltaNs + " ns");
    }
  }

  /**
   * Delta for messages that are repeated as the mutex does.
   *
   * @param longestDelayNs no message that arrives takes longer
   * @param loss probability that a message is lost; where nearly all are, a day
   */
  public static long deltaNs(long longestDelayNs, double loss) {
    double fails = 1 - (1 - loss) * (1 - loss);
    long deltaNs = longestDelayNs;
    MutexTimes times = MutexTimes.DEFAULT;
    double waitNs = (double) times.resendMs() * NS_PER_MS;
    double all = fails;
    while (all > NEVER && deltaNs < DAY_NS) {
      deltaNs += (long) waitNs + NEWS_NS;
      waitNs = Math.min(waitNs * times.backoff(), (double) times.maxResendMs() * NS_PER_MS);
      all *= fails;
    }
    return deltaNs;
  }

  /** From coming onto the floor to leaving it: in the worst case cars cross one after another. */
  long trafficNs() {
    long turnNs = NETWORK_NS + DRIVE_NS + TURNS_NS;
    // On an open road others come after this car, but none comes before it once it is at the head.
    int turns = places == 0 ? cars : (places + 1) * (TURNS_BEFORE + 1);
    return turns * turnNs + DEBRIS_NS;
  }

  /** After the end of arrivals everybody is gone within this time, unless something is wrong. */
  public long drainNs() {
    return trafficNs() + NETWORK_NS;
  }

  /** Of the mutex on the crossing's zones. */
  MutexBounds zones() {
    return MutexBounds.of(Math.max(1, cars), DRIVE_NS + TURNS_NS, deltaNs);
  }

  /** Of the mutex on places: who holds one waits for its zones with it. */
  MutexBounds queue() {
    return MutexBounds.of(Math.max(1, cars), trafficNs(), deltaNs);
  }
}

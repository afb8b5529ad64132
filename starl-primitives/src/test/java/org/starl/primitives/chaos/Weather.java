package org.starl.primitives.chaos;

/**
 * How badly a network and a disk behave.
 *
 * @param loss probability that a message is lost
 * @param duplicate probability that it comes twice
 * @param minDelayMs shortest delay; delays are uniform, so messages overtake each other
 * @param maxDelayMs longest delay
 * @param maxFlushMs longest time that a write takes to become stable
 */
public record Weather(
    double loss, double duplicate, long minDelayMs, long maxDelayMs, long maxFlushMs) {

  public static final Weather TEN_MS = new Weather(0, 0, 10, 10, 0);
  public static final Weather FAIR = new Weather(0, 0, 10, 20, 0);
  public static final Weather LOSSY = new Weather(0.3, 0, 10, 200, 0);
  public static final Weather FOUL = new Weather(0.25, 0.2, 1, 400, 50);
}

package org.starl.comms;

/**
 * How long a reliable message is tried. The defaults are the original StarL's, 250 ms and 15
 * retries, with a backoff.
 *
 * @param firstRetryMs wait for the first acknowledgement, in ms
 * @param backoff factor from one wait to the next, at least 1
 * @param maxWaitMs no wait is longer
 * @param maxRetries transmissions after the first one
 * @param deadlineMs given up after this time, whatever the retries
 */
public record Reliability(
    long firstRetryMs, double backoff, long maxWaitMs, int maxRetries, long deadlineMs) {

  public static final Reliability DEFAULT = new Reliability(250, 1.5, 2_000, 15, 30_000);

  public Reliability {
    if (firstRetryMs <= 0
        || !(backoff >= 1)
        || maxWaitMs < firstRetryMs
        || maxRetries < 0
        || deadlineMs <= 0) {
      throw new IllegalArgumentException(
          "reliability: expected waits above 0, backoff at least 1, retries not negative");
    }
  }
}

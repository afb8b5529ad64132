package org.starl.comms;

/**
 * Retransmission parameters of a reliable message. The defaults are the original StarL's (250 ms,
 * 15 retries) plus a backoff.
 *
 * @param firstRetryMs time to the first retransmission, in ms
 * @param backoff factor from one wait to the next, at least 1
 * @param maxWaitMs maximum time between retransmissions
 * @param maxRetries number of retransmissions
 * @param deadlineMs time after which the message fails, whatever the retries
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

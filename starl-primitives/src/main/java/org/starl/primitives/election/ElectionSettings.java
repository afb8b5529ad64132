package org.starl.primitives.election;

import org.starl.primitives.agreement.SynodTiming;

/**
 * Strategy and times of an election, of no weight for its safety.
 *
 * @param strategy whom to propose, and when; robots may differ in it
 * @param timing how patiently leaders are proposed
 * @param deltaMs how long a message usually takes at most, in ms, a resend or two included
 * @param heartbeatMs a leader tells that it is there every so many ms
 * @param silenceMs a leader is suspected when nothing has been heard of it for so many ms
 * @param deadlineMs {@code Leader} is null for at most so many ms on end; then it is fail
 */
public record ElectionSettings(
    ElectionStrategy strategy,
    SynodTiming timing,
    long deltaMs,
    long heartbeatMs,
    long silenceMs,
    long deadlineMs) {

  public static final ElectionSettings DEFAULT =
      new ElectionSettings(
          ElectionStrategy.RANDOM_BALLOT, SynodTiming.DEFAULT, 250, 250, 2_500, 30_000);

  public ElectionSettings {
    if (deltaMs <= 0 || heartbeatMs <= 0 || silenceMs <= heartbeatMs || deadlineMs <= 2 * deltaMs) {
      throw new IllegalArgumentException(
          "election: expected times above 0, silence above the heartbeat, deadline above two delays");
    }
  }

  public ElectionSettings withStrategy(ElectionStrategy newStrategy) {
    return new ElectionSettings(newStrategy, timing, deltaMs, heartbeatMs, silenceMs, deadlineMs);
  }

  public ElectionSettings withDeadlineMs(long newDeadlineMs) {
    return new ElectionSettings(strategy, timing, deltaMs, heartbeatMs, silenceMs, newDeadlineMs);
  }
}

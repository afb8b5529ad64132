package org.starl.primitives.election;

import org.starl.primitives.agreement.SynodTiming;

/**
 * Strategy and times of an election. Safety does not depend on them.
 *
 * @param strategy the choice of the candidate to propose, and when; robots may use different ones
 * @param timing the waits of proposers
 * @param deltaMs the usual longest message delay, in ms, one or two resends included
 * @param heartbeatMs the period of a leader's heartbeat, in ms
 * @param silenceMs a leader that was not heard for this time, in ms, is suspected
 * @param deadlineMs {@code Leader} is null for at most this time, in ms; then it is fail
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

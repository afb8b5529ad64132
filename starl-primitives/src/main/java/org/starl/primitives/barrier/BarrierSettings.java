package org.starl.primitives.barrier;

import org.starl.primitives.agreement.SynodTiming;

/**
 * Times of a barrier. Safety does not depend on them.
 *
 * @param timing the waits of proposers
 * @param deltaMs the usual longest message delay, in ms, one or two resends included
 * @param repeatMs a waiting robot asks the absent members with this period, in ms
 * @param silenceMs a member that does not answer is suspected after this time, in ms, and excluded
 * @param deadlineMs an absent member is excluded after this time, in ms, even if it is alive; after
 *     twice this time, a waiting robot is told that the outcome is unknown
 */
public record BarrierSettings(
    SynodTiming timing, long deltaMs, long repeatMs, long silenceMs, long deadlineMs) {

  public static final BarrierSettings DEFAULT =
      new BarrierSettings(SynodTiming.DEFAULT, 250, 500, 5_000, 60_000);

  public BarrierSettings {
    if (deltaMs <= 0 || repeatMs <= 0 || silenceMs <= repeatMs || deadlineMs <= 0) {
      throw new IllegalArgumentException(
          "barrier: expected times above 0, and silence above the repeat");
    }
  }

  public BarrierSettings withSilenceMs(long newSilenceMs) {
    return new BarrierSettings(timing, deltaMs, repeatMs, newSilenceMs, deadlineMs);
  }

  public BarrierSettings withDeadlineMs(long newDeadlineMs) {
    return new BarrierSettings(timing, deltaMs, repeatMs, silenceMs, newDeadlineMs);
  }
}

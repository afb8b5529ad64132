package org.starl.primitives.barrier;

import org.starl.primitives.agreement.SynodTiming;

/**
 * Times of a barrier, of no weight for its safety.
 *
 * @param timing how patiently outcomes are proposed
 * @param deltaMs how long a message usually takes at most, in ms, a resend or two included
 * @param repeatMs who waits asks those who have not arrived every so many ms
 * @param silenceMs who does not even answer is suspected after so many ms, and left out
 * @param deadlineMs after so many ms, who has not arrived is left out, however alive; after twice as
 *     many, who waits is told that the outcome is unknown
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

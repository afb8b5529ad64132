package org.starl.primitives.agreement;

/**
 * Times of an agreement. Safety does not depend on them.
 *
 * @param timing the waits of proposers
 * @param deadlineMs a proposal is given up after this time, in ms, and {@code failed} becomes true
 */
public record AgreementSettings(SynodTiming timing, long deadlineMs) {

  public static final AgreementSettings DEFAULT =
      new AgreementSettings(SynodTiming.DEFAULT, 30_000);

  public AgreementSettings {
    if (deadlineMs <= 0) {
      throw new IllegalArgumentException(
          "agreement: deadline " + deadlineMs + " ms: expected above 0");
    }
  }

  public AgreementSettings withDeadlineMs(long newDeadlineMs) {
    return new AgreementSettings(timing, newDeadlineMs);
  }
}

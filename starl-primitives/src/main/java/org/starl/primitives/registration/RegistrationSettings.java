package org.starl.primitives.registration;

import org.starl.primitives.agreement.SynodTiming;

/**
 * Times of a registration. Safety does not depend on them.
 *
 * @param timing the waits of proposers
 * @param deadlineMs a call is given up after this time, in ms, and {@code failed} becomes true
 * @param nullMs a rumour of a newer view keeps {@code rList} null for at most this time, in ms
 * @param queryMs a registered robot asks the acceptors in turn for a newer view, one in this period, in
 *     ms
 */
public record RegistrationSettings(SynodTiming timing, long deadlineMs, long nullMs, long queryMs) {

  public static final RegistrationSettings DEFAULT =
      new RegistrationSettings(SynodTiming.DEFAULT, 30_000, 1_000, 2_000);

  public RegistrationSettings {
    if (deadlineMs <= 0 || nullMs <= 0 || queryMs <= 0) {
      throw new IllegalArgumentException("registration: expected times above 0");
    }
  }

  public RegistrationSettings withDeadlineMs(long newDeadlineMs) {
    return new RegistrationSettings(timing, newDeadlineMs, nullMs, queryMs);
  }
}

package org.starl.primitives.registration;

import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.membership.View;

/**
 * Times of a registration, of no weight for its safety.
 *
 * @param timing how patiently views are proposed
 * @param deadlineMs a call is given up after so many ms, and {@code failed} is told
 * @param nullMs {@code rList} is null at most so many ms for views that are only rumoured
 * @param queryMs a registered robot asks one acceptor for news every so many ms, each in turn
 * @param initialView the first view if the deployment gives one, else {@link View#NONE}; the same on
 *     every robot
 */
public record RegistrationSettings(
    SynodTiming timing, long deadlineMs, long nullMs, long queryMs, View initialView) {

  public static final RegistrationSettings DEFAULT =
      new RegistrationSettings(SynodTiming.DEFAULT, 30_000, 1_000, 2_000, View.NONE);

  public RegistrationSettings {
    if (deadlineMs <= 0 || nullMs <= 0 || queryMs <= 0) {
      throw new IllegalArgumentException("registration: expected times above 0");
    }
  }

  public RegistrationSettings withDeadlineMs(long newDeadlineMs) {
    return new RegistrationSettings(timing, newDeadlineMs, nullMs, queryMs, initialView);
  }

  public RegistrationSettings withInitialView(View newInitialView) {
    return new RegistrationSettings(timing, deadlineMs, nullMs, queryMs, newInitialView);
  }
}

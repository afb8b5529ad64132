package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.spec.Monitors;
import org.starl.time.Time;

/** Whether a robot that leaves stays until others know its last view. */
class RegistrationStaysTest {

  @Test
  void aRobotThatEndsBeforeAllKnowItsViewViolatesStays() {
    long boundNs = RegistrationProtocol.BROADCAST_MS * Time.NS_PER_MS;
    assertThat(endsEarly(7, "v", "c")).isZero();
    assertThat(endsEarly(7, "v")).as("c, which it has removed").isEqualTo(1);
    assertThat(endsEarly(5 + boundNs - 1, "c")).as("the acceptor v").isEqualTo(1);
    assertThat(endsEarly(5 + boundNs)).as("for so long").isZero();
  }

  /** The voter b decides the view 2, which removes b and c, and ends when these robots have heard of it. */
  private static long endsEarly(long endNs, String... heard) {
    Monitors patient =
        new Monitors(List.of(new RegistrationSpec(1_000).patient(RegistrationSettings.DEFAULT)));
    patient.observe(Shown.acceptors(0, "b", "b", "v"));
    for (String name : List.of("b", "c")) {
      patient.observe(Shown.acts(0, name, "do_register", name));
      patient.observe(Shown.sees(1, name, "1:b@1,c@1"));
    }
    patient.observe(Shown.hearsVote(5, "b", "v", 2));
    patient.observe(Shown.sees(5, "b", "2:"));
    for (String robot : heard) {
      patient.observe(Shown.hearsView(6, robot, "b", 2));
    }
    patient.observe(Shown.unregistered(endNs, "b"));
    assertThat(patient.report().checks(RegistrationSpec.STAYS)).isEqualTo(1);
    return patient.report().violations(RegistrationSpec.STAYS);
  }
}

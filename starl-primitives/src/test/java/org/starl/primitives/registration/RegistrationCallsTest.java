package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.spec.Monitors;

/** What a robot shows of its calls, and which ids it gives up, by traces written by hand. */
class RegistrationCallsTest {

  @Test
  void failedFollowsTheLatestCallAndTheRobotsRemoval() {
    for (boolean isShown : List.of(true, false)) {
      Monitors patient = RegistrationSpecTest.showsItsList(1_000);
      patient.observe(Shown.failed(1, "a", false));
      patient.observe(Shown.sees(5, "a", "2:"));
      if (isShown) {
        patient.observe(Shown.failed(5, "a", true));
      }
      patient.observe(Shown.acts(6, "a", "do_register", "a.2"));
      assertThat(patient.report().violations(RegistrationSpec.FAILED)).isEqualTo(isShown ? 0 : 1);
      patient.observe(Shown.failed(6, "a", !isShown));
      patient.observe(Shown.unregistered(7, "a"));
      assertThat(patient.report().violations(RegistrationSpec.FAILED)).isEqualTo(isShown ? 0 : 2);
    }
  }

  @Test
  void anIdThatIsGivenUpThoughNoViewCanHaveHadItViolatesFresh() {
    for (long number : List.of(1L, 2L)) {
      Monitors patient =
          new Monitors(List.of(new RegistrationSpec().patient(RegistrationSettings.DEFAULT)));
      patient.observe(Shown.sees(0, "a", "0:"));
      patient.observe(Shown.acts(0, "a", "do_register", "a"));
      patient.observe(Shown.proposes(0, "a", 1));
      patient.observe(Shown.acts(2, "a", "give_up", "a"));
      patient.observe(Shown.acts(2, "a", "do_register", "a.2"));
      patient.observe(Shown.proposes(2, "a", number + 1));
      patient.observe(Shown.sees(2, "a", number + ":"));
      assertThat(patient.report().violations(RegistrationSpec.FRESH)).isEqualTo(2 - number);
    }
  }
}

package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Outcome;
import org.starl.primitives.exhaustive.Visits;

/** All states of the Synod's code on small instances. */
class SynodExplorationTest {

  @ParameterizedTest
  @CsvSource({
    "robots=2 callers=1 crashes=1, 517",
    "robots=2, 400",
    "robots=2 timers=1, 1766",
    "robots=2 voters=1 crashes=1, 1437",
    "robots=3 callers=1 crashes=1, 34376",
    "robots=3 callers=2, 11690",
  })
  void robotsAgree(String bounds, int states) {
    Visits.assertHolds(SynodStates.SPACE, bounds, states);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "robots=3 callers=2 timers=1, 86967",
  })
  void robotsAgreeInManyStates(String bounds, int states) {
    Visits.assertHolds(SynodStates.SPACE, bounds, states);
  }

  @Test
  void anAcceptorThatForgetsIsFoundWithItsSteps() {
    String bounds = "robots=2 voters=1 crashes=1";
    SynodStates forgets = new SynodStates(Visits.bounds(SynodStates.SPACE, bounds), true);
    Outcome outcome = new StateSearch<>(forgets).run(1_000, states -> {});
    assertThat(outcome.violation()).hasSize(12).last().asString().startsWith("Agreement");
  }
}

package org.starl.primitives.specimen;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.primitives.agreement.AgreementConformance;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** Agreements that are none: the specification must see each, or it proves nothing. */
class NaiveAgreementTest {

  private static final int SEEDS = 20;
  private static final Duration BOUND = Duration.ofSeconds(5);

  @ParameterizedTest
  @CsvSource({
    "FIRST_HEARD, agreement.Agreement",
    "SUM_OF_ALL, agreement.Validity",
    "LEAST_OF_ALL, agreement.Decided",
    "FIRST_HEARD, SetAgreement_decls",
    "SUM_OF_ALL, SetAgreement_decls",
  })
  void naiveAgreementsAreDetected(NaiveAgreement.Way way, String lemma) {
    long seed = 0;
    SimResult result;
    do {
      seed++;
      result =
          Simulation.builder()
              .seed(seed)
              .settings(
                  SimSettings.builder().duration(BOUND.multipliedBy(2)).messageLoss(0.2).build())
              .robots(4, gvh -> new NaiveAgreement(gvh, way))
              .monitor(() -> new AgreementSpec(BOUND.toNanos()))
              .monitor(AgreementConformance::new)
              .build()
              .run();
    } while (result.spec().violations(lemma) == 0 && seed < SEEDS);
    assertThat(result.spec().violations(lemma)).as("%s, seeds 1..%d", way, SEEDS).isPositive();
  }
}

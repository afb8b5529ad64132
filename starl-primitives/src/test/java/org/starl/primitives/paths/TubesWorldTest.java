package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.primitives.paths.TubesWorld.Bugs;
import org.starl.spec.SpecReport;

/** The claims' protocol by itself, as it is and with planted bugs. */
class TubesWorldTest {

  private static final int ROBOTS = 5;
  private static final int STEPS = 4_000;

  @Property(tries = 30, edgeCases = EdgeCasesMode.NONE)
  void noTwoTubesMeetWhateverTheNetworkAndTheVotersDo(@ForAll long seed) {
    TubesWorld world = new TubesWorld(seed, ROBOTS, Bugs.none(ROBOTS));
    SpecReport report = world.run(STEPS);
    assertThat(report.violations()).isEmpty();
    assertThat(world.granted()).as("a run in which nothing is granted tests nothing").isPositive();
  }

  @Test
  void aClaimOfLessThanAMajorityIsCaught() {
    assertThat(violations(new Bugs(ROBOTS / 2, false, false, false))).isPositive();
  }

  @Test
  void aVoterThatForgetsItsConsentOverARestartIsCaught() {
    assertThat(violations(new Bugs(ROBOTS / 2 + 1, true, false, false))).isPositive();
  }

  @Test
  void aVoteBeforeItsNoteIsFlushedIsCaught() {
    assertThat(violations(new Bugs(ROBOTS / 2 + 1, false, true, false))).isPositive();
  }

  @Test
  void aVoterThatLooksAtOneTubeOfEachOnlyIsCaught() {
    assertThat(violations(new Bugs(ROBOTS / 2 + 1, false, false, true))).isPositive();
  }

  private static long violations(Bugs bugs) {
    long violations = 0;
    for (long seed = 1; seed <= 100 && violations == 0; seed++) {
      violations = new TubesWorld(seed, ROBOTS, bugs).run(STEPS).violations(TubesSpec.TUBES);
    }
    return violations;
  }
}

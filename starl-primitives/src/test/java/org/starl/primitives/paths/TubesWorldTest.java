package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.junit.jupiter.api.Test;
import org.starl.primitives.paths.TubesWorld.Bugs;

/** The protocol of claims without robots, correct and with planted bugs. */
class TubesWorldTest {

  private static final int ROBOTS = 5;
  private static final int STEPS = 4_000;

  @Property(tries = 30, edgeCases = EdgeCasesMode.NONE)
  void noTwoTubesMeetUnderAnyFaults(@ForAll long seed) {
    TubesWorld world = new TubesWorld(seed, ROBOTS, Bugs.none(ROBOTS));
    assertThat(world.run(STEPS).violations()).isEmpty();
    // A run without a grant tests nothing; about one run in five hundred has none.
    Statistics.label("something is granted")
        .collect(world.granted() > 0)
        .coverage(tries -> tries.check(true).percentage(share -> share > 50));
    assertThat(world.grantedOnceWhole()).as("nobody is stuck for good").isEqualTo(ROBOTS);
    assertThat(world.run(0).violations()).isEmpty();
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
  void aVoterThatChecksOnlyOneTubePerRobotIsCaught() {
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

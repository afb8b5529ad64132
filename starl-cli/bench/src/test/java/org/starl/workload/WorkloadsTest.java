package org.starl.workload;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.input.BadInput;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.check.Determinism;

/** All primitives' workloads. */
class WorkloadsTest {

  static Stream<String> names() {
    return PrimitiveWorkloads.ALL.stream().map(Demo::name);
  }

  @ParameterizedTest
  @MethodSource("names")
  void withoutFaultsEveryRobotIsServedAndEveryLemmaIsChecked(String name) {
    Plan plan = Runs.plan(name, 7, Map.of("busy", "5s", "positionNoise", "5mm"));
    SimResult result = plan.simulation().build().run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.isFinished()).isTrue();
    assertThat(result.spec().lemmas())
        .isNotEmpty()
        .filteredOn(lemma -> !MatrixTest.ONLY_WITH_FAULTS.contains(lemma))
        .allSatisfy(lemma -> assertThat(result.spec().checks(lemma)).as(lemma).isPositive());
    // A campaign without faults must not fail for what only a fault can make a robot do.
    assertThat(result.spec().neverChecked())
        .filteredOn(lemma -> result.spec().inapplicable(lemma).isEmpty())
        .isSubsetOf("election.Behind");
    assertThat(plan.story().measures().completed()).isEqualTo(5);
    assertThat(plan.story().measures().waitsNs()).hasSizeGreaterThanOrEqualTo(25);
    assertThat(plan.story().measures().counts().get("rounds")).isGreaterThanOrEqualTo(25);
    assertThat(plan.story().lines()).hasSize(5).allMatch(line -> line.contains(" was served "));
  }

  @ParameterizedTest
  @ValueSource(strings = {"agreement", "barrier", "election", "ledger", "mutex", "registration"})
  void aRunThatLosesAllMessagesDoesNotFinish(String name) {
    Plan plan = Runs.plan(name, 7, Map.of("faults", "loss(1,at=5s)"));
    SimResult result = plan.simulation().build().run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.unfinished()).isNotEmpty();
    assertThat(plan.story().lines()).contains("faults: 1 loss");
  }

  @ParameterizedTest
  @MethodSource("names")
  void chaosDependsOnTheSeedAlone(String name) throws IOException {
    Map<String, String> set = Map.of("busy", "3s", "chaos", "logical", "rounds", "4");
    Determinism check = Determinism.verify(() -> Runs.plan(name, 3, set).simulation());
    assertThat(check.holds()).as("%s", check.difference()).isTrue();
  }

  /** Robots without a key accept them: then a specification may fail, but no program ends. */
  @ParameterizedTest
  @MethodSource("names")
  void noChangedMessageEndsAProgram(String name) {
    for (long seed = 1; seed <= 3; seed++) {
      Map<String, String> set = Map.of("faults", "forge(all,10ms)", "duration", "40s");
      Plan plan = Runs.plan(name, seed, set);
      assertThatCode(() -> plan.simulation().build().run()).doesNotThrowAnyException();
    }
  }

  @Test
  void roundsAreSpreadAndTheLastThreeBeginAfterTheFaults() {
    Course course = new Course(5, 10_000);
    assertThat(List.of(0, 1, 2, 3, 4))
        .extracting(course::beginMs)
        .containsExactly(0L, 5_000L, 12_000L, 12_000L, 12_000L);
    assertThat(new Course(2, 10_000).beginMs(0)).isEqualTo(12_000);
  }

  @Test
  void deltaGrowsWithLossAndDelay() {
    long none = Setup.deltaNs(SimSettings.builder().set("messageDelay", "100ms").build());
    assertThat(none).isEqualTo(2_100_000_000L);
    SimSettings.Builder lossy = SimSettings.builder().set("messageLoss", "0.5");
    // 0.75 to the 73rd is below one in a thousand million.
    assertThat(Setup.deltaNs(lossy.set("messageDelay", "uniform(1s,2s)").build()))
        .isEqualTo(2_000_000_000L + 74 * 2_000_000_000L);
  }

  @Test
  void badParametersAreRefused() {
    assertRefused("mutex", "members", "some", "registered, fixed, changing");
    assertRefused("mutex", "sections", "27", "1 to 26");
    assertRefused("election", "strategy", "loud", "random, bully");
    assertRefused("agreement", "rounds", "0", "rounds");
    assertRefused("geocast", "busy", "20", "busy");
  }

  private static void assertRefused(String name, String key, String value, String expected) {
    assertThatThrownBy(() -> Runs.plan(name, 1, Map.of(key, value)))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(expected);
  }
}

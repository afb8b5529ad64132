package org.starl.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.bench.CrossingRules.Flow;
import org.starl.bench.CrossingRules.Rule;
import org.starl.random.Rng;
import org.starl.sim.SimResult;
import org.starl.time.Time;

/** The runs that b4a, b4b and b5 measure are the ones that they describe. */
final class CrossingRulesTest {

  @Test
  void underEachRuleTheSameCarsCrossAndNoneTouch() {
    Map<Rule, Flow> flows = new EnumMap<>(Rule.class);
    for (Rule rule : Rule.values()) {
      Flow flow = CrossingRules.run(rule, 8, 0, Duration.ofSeconds(120), 3);
      assertThat(flow.contacts()).as("%s", rule).isZero();
      int arrived = (int) flow.figure("arrived");
      assertThat(arrived).isGreaterThan(8);
      assertThat(flow.measures().completed())
          .isEqualTo(flow.measures().waitsNs().size())
          .isBetween(arrived - 4, arrived);
      flows.put(rule, flow);
    }
    assertThat(flows.values())
        .extracting(flow -> flow.figure("arrived"))
        .containsOnly(flows.get(Rule.FLOW).figure("arrived"));
    assertThat(delayS(flows.get(Rule.FLOW))).isLessThan(delayS(flows.get(Rule.PAPER)));
    assertThat(delayS(flows.get(Rule.PAPER))).isLessThan(delayS(flows.get(Rule.LOCK)));
    assertThat(flows.get(Rule.STOP).measures().waitsNs())
        .as("the stop")
        .allMatch(waitNs -> waitNs >= 2 * Time.NS_PER_S);
  }

  @Test
  void aFencedCarThatHoldsSectionsWaitsUntilItIsRemovedAndRegistersAgain() {
    Flow flow = CrossingRules.run(Rule.FLOW, 8, 0.5, Duration.ofSeconds(240), 4);
    assertThat(flow.measures().completed() + flow.figure("turned_away"))
        .isEqualTo(flow.figure("arrived"));
    assertThat(flow.contacts()).isZero();
  }

  private static double delayS(Flow flow) {
    return flow.figure("delay_mean_s");
  }

  @Test
  void carsKeepCrossingAtEachIntersectionOfATown() {
    TownWorkload.Town town = new TownWorkload.Town(3, new Rng(1));
    SimResult result = TownWorkload.plan(12, town, 1).build().run();
    assertThat(town.crossed()).isGreaterThan(12);
    assertThat(town.crossedAt()).as("at each intersection").hasSize(3).doesNotContain(0);
    assertThat(result.collisions().ofRobots()).isZero();
  }

  @Test
  void stepsAreTheEventsThatRunOnRobots() {
    SimResult result = CheckSpeed.simulation(5).build().run();
    long steps = CheckSpeed.steps(5);
    assertThat(steps).isEqualTo(CheckSpeed.steps(5)).isLessThan(result.events());
    assertThat(steps).isGreaterThan(result.events() / 2);
  }
}

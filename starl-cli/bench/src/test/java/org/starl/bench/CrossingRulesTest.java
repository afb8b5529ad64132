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

/** The runs that b4a, b4b and b5 measure are the ones that they describe. */
final class CrossingRulesTest {

  @Test
  void underEachRuleTheSameCarsCrossAndNoneTouch() {
    Map<Rule, Flow> flows = new EnumMap<>(Rule.class);
    for (Rule rule : Rule.values()) {
      Flow flow = CrossingRules.run(rule, 8, Duration.ofSeconds(120), 3);
      assertThat(flow.contacts()).as("%s", rule).isZero();
      assertThat(flow.arrived()).isGreaterThan(8);
      assertThat(flow.crossed())
          .isEqualTo(flow.waitsS().size())
          .isBetween(flow.arrived() - 4, flow.arrived());
      flows.put(rule, flow);
    }
    assertThat(flows.values())
        .extracting(Flow::arrived)
        .containsOnly(flows.get(Rule.MUTEX).arrived());
    assertThat(total(flows.get(Rule.MUTEX))).isLessThan(total(flows.get(Rule.LOCK)));
    assertThat(flows.get(Rule.STOP).waitsS().get(0)).as("the stop").isGreaterThanOrEqualTo(2);
  }

  private static double total(Flow flow) {
    return flow.waitsS().stream().mapToDouble(Double::doubleValue).sum();
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

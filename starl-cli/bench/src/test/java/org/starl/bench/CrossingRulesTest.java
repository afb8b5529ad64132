package org.starl.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
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
      Flow flow = CrossingRules.run(rule, 8, List.of(), Duration.ofSeconds(120), 3);
      assertThat(flow.contacts()).as("%s", rule).isZero();
      int arrived = (int) flow.arrived();
      assertThat(arrived).isGreaterThan(8);
      assertThat(flow.completed()).isBetween(arrived - 4, arrived);
      flows.put(rule, flow);
    }
    assertThat(flows.values())
        .extracting(Flow::arrived)
        .containsOnly(flows.get(Rule.FLOW).arrived());
    assertThat(flows.get(Rule.FLOW).delayMeanS()).isLessThan(flows.get(Rule.PAPER).delayMeanS());
    assertThat(flows.get(Rule.PAPER).delayMeanS()).isLessThan(flows.get(Rule.LOCK).delayMeanS());
    assertThat(flows.get(Rule.STOP).shortestWaitNs()).isGreaterThanOrEqualTo(2 * Time.NS_PER_S);
  }

  @Test
  void aFencedCarThatHoldsSectionsWaitsUntilItIsRemovedAndRegistersAgain() {
    Flow flow = CrossingRules.run(Rule.FLOW, 8, List.of("loss(0.5)"), Duration.ofSeconds(240), 4);
    assertThat(flow.completed() + flow.turnedAway()).isEqualTo(flow.arrived());
    assertThat(flow.contacts()).isZero();
  }

  @Test
  void sumoHasTheSameCarsWhereItIsInstalled() {
    assumeTrue(CrossingRules.hasSumo(), "skipped: netconvert and sumo are not on the PATH");
    Sumo sumo = Sumo.find().orElseThrow();
    Flow ours = CrossingRules.run(Rule.FLOW, 8, List.of(), Duration.ofSeconds(120), 3);
    for (Sumo.Control control : Sumo.Control.values()) {
      Flow theirs = sumo.run(control, 8, Duration.ofSeconds(120), 3);
      assertThat(theirs.arrived()).as("%s", control).isEqualTo(ours.arrived());
      assertThat(theirs.delayMeanS()).isBetween(0.1, 30.0);
    }
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

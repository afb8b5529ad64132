package org.starl.primitives.barrier;

import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.ProcessId;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.Visits;
import org.starl.random.Rng;

/** All states of the barrier's code on small instances. */
class BarrierExplorationTest {

  @ParameterizedTest
  @CsvSource({
    "robots=2, 98",
    "robots=2 timers=1, 6754",
    "robots=2 crashes=1, 1985",
    "robots=3, 15005",
    "robots=3 callers=2 timers=1, 19949",
    "robots=3 callers=1 timers=2, 17499",
  })
  void robotsAreToldOneOutcome(String bounds, int states) {
    Visits.assertHolds(BarrierStates.SPACE, bounds, states);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "robots=2 timers=2, 99358",
    "robots=2 generations=2 timers=1, 57968",
    "robots=2 crashes=1 timers=1, 88094",
  })
  void robotsAreToldOneOutcomeInManyStates(String bounds, int states) {
    Visits.assertHolds(BarrierStates.SPACE, bounds, states);
  }

  @Test
  void countingAnArrivalForThePresentGenerationIsFound() {
    Visits.assertFinds(
        search(
            "generations=2",
            (id, first, node, now) ->
                new BarrierProtocol(
                    id, first, BarrierStates.SETTINGS, new Rng(1), node, node, now) {
                  @Override
                  void count(ProcessId who, long itsGeneration) {
                    super.count(who, generation());
                  }
                }),
        BarrierSpec.NO_EARLY);
  }

  @Test
  void aRobotThatDecidesAloneAtItsDeadlineIsFound() {
    Visits.assertFinds(
        search(
            "timers=1",
            (id, first, node, now) ->
                new BarrierProtocol(
                    id, first, BarrierStates.SETTINGS, new Rng(1), node, node, now) {
                  @Override
                  void deadline() {
                    SortedSet<ProcessId> others = new TreeSet<>(first);
                    others.remove(id);
                    next(new BarrierOutcome.Failed(generation(), others));
                  }
                }),
        BarrierSpec.UNIFORM);
  }

  /** Makes a broken protocol. */
  private interface Maker {
    BarrierProtocol make(
        ProcessId id, SortedSet<ProcessId> first, BarrierStates.Node node, long nowNs);
  }

  private static StateSearch<?, ?, ?> search(String bounds, Maker maker) {
    return new StateSearch<>(
        new BarrierStates(Visits.bounds(BarrierStates.SPACE, bounds)) {
          @Override
          BarrierProtocol program(ProcessId me, Node node, long nowNs) {
            return maker.make(me, first(), node, nowNs);
          }
        });
  }
}

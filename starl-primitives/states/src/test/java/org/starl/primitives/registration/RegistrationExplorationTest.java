package org.starl.primitives.registration;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.BinaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.Visits;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;

/** All states of the registration's code on small instances. */
class RegistrationExplorationTest {

  @ParameterizedTest
  @CsvSource({
    "robots=1 crashes=1, 155",
    "robots=1 crashes=1 returns=1, 758",
    "robots=2, 878",
    "robots=2 timers=1, 10261",
    "robots=2 confinements=1, 6457",
    "robots=2 callers=1 crashes=1, 18603",
    "robots=3 callers=1 leaves=1, 2285",
  })
  void robotsKnowTheSameViews(String bounds, int states) {
    Visits.assertHolds(RegistrationStates.SPACE, bounds, states);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "robots=2 leaves=1, 24849",
  })
  void robotsKnowTheSameViewsInManyStates(String bounds, int states) {
    Visits.assertHolds(RegistrationStates.SPACE, bounds, states);
  }

  @Test
  void aViewThatLacksAMemberIsFound() {
    assertFinds(
        "robots=2",
        (decided, next) -> {
          SortedMap<ProcessId, Long> fewer = new TreeMap<>(next.admitted());
          fewer.keySet().removeAll(decided.ids());
          return new View(next.number(), fewer);
        },
        RegistrationSpec.KEEPS);
  }

  @Test
  void aViewWithAnIdThatNeverAskedIsFound() {
    ProcessId unasked = ProcessId.first(new RobotId("bot0"), 9);
    assertFinds(
        "robots=1",
        (decided, next) -> next.contains(unasked) ? next : next.with(unasked),
        RegistrationSpec.SOUNDNESS);
  }

  /**
   * @param wrong the proposal, of the decided view and the right proposal
   */
  private static void assertFinds(String bounds, BinaryOperator<View> wrong, String invariant) {
    RegistrationStates broken =
        new RegistrationStates(Visits.bounds(RegistrationStates.SPACE, bounds)) {
          @Override
          RegistrationProtocol program(Node node, long nowNs) {
            return new RegistrationProtocol(
                node.name, names(), SETTINGS, new Rng(1), node, node, nowNs) {
              @Override
              View proposal(View decided, Change wanted, List<Value> wishes) {
                return wrong.apply(decided, super.proposal(decided, wanted, wishes));
              }
            };
          }
        };
    Visits.assertFinds(new StateSearch<>(broken), invariant);
  }
}

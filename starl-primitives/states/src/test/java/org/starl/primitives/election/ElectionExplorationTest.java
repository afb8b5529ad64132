package org.starl.primitives.election;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.primitives.election.ElectionMessage.Elected;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.Visits;
import org.starl.random.Rng;

/** All states of the election's code on small instances. */
class ElectionExplorationTest {

  @ParameterizedTest
  @CsvSource({
    "robots=2, 3195",
    "robots=2 others=1, 5718",
    "robots=2 callers=1 timers=3, 4215",
    "robots=3 callers=1 timers=2, 22601",
  })
  void atMostOneLeaderInATerm(String bounds, int states) {
    Visits.assertHolds(ElectionStates.SPACE, bounds, states);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "robots=2 timers=1, 116691",
    "robots=2 callers=1 crashes=1, 64452",
  })
  void atMostOneLeaderInATermInManyStates(String bounds, int states) {
    Visits.assertHolds(ElectionStates.SPACE, bounds, states);
  }

  @Test
  void aLeaderWithoutADecisionIsFound() {
    Visits.assertFinds(
        search(
            "robots=2",
            (id, names, node, now) ->
                new ElectionProtocol(
                    id, names, ElectionStates.SETTINGS, new Rng(1), node, node, now) {
                  @Override
                  void propose(ProcessId candidate) {
                    decided(term(), candidate);
                  }
                }),
        ElectionSpec.AGREEMENT);
  }

  @Test
  void anAnswerOfAnotherTermIsFound() {
    Visits.assertFinds(
        search(
            "timers=1",
            (id, names, node, now) ->
                new ElectionProtocol(
                    id, names, ElectionStates.SETTINGS, new Rng(1), node, node, now) {
                  @Override
                  void elected(Elected m) {
                    decided(Math.max(term(), 1), m.leader());
                  }
                }),
        ElectionSpec.SOUNDNESS);
  }

  /** Makes a broken protocol. */
  private interface Maker {
    ElectionProtocol make(ProcessId id, Participants names, ElectionStates.Node node, long nowNs);
  }

  private static StateSearch<?, ?, ?> search(String bounds, Maker maker) {
    return new StateSearch<>(
        new ElectionStates(Visits.bounds(ElectionStates.SPACE, bounds)) {
          @Override
          ElectionProtocol program(ProcessId me, Node node, long nowNs) {
            return maker.make(me, names(), node, nowNs);
          }
        });
  }
}

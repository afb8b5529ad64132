package org.starl.primitives.paths;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.Visits;

/** All states of the code for reach tubes on small instances. */
class TubeExplorationTest {

  @ParameterizedTest
  @CsvSource({
    "robots=2, 8705",
    "robots=2 withdrawals=1, 27463",
    "robots=2 placed=1, 2434",
    "robots=3 placed=1 callers=1, 261",
  })
  void noTwoRobotsHoldTubesThatMeet(String bounds, int states) {
    Visits.assertHolds(TubeStates.SPACE, bounds, states);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({
    "robots=2 placed=1 callers=1 crashes=2, 196958",
    "robots=3 placed=1 callers=2, 196774",
  })
  void noTwoRobotsHoldTubesThatMeetInManyStates(String bounds, int states) {
    Visits.assertHolds(TubeStates.SPACE, bounds, states);
  }

  @Test
  void aRobotThatCountsARefusalAsAConsentIsFound() {
    Visits.assertFinds(
        new StateSearch<>(
            new TubeStates(Visits.bounds(TubeStates.SPACE, "robots=2 placed=1")) {
              @Override
              public void receive(Node node, Packet packet) {
                super.receive(
                    node,
                    packet.content() instanceof TubeMessage.Refuse refusal
                        ? new Packet(
                            packet.from(), packet.to(), new TubeMessage.Vote(refusal.version()))
                        : packet);
              }
            }),
        TubesSpec.TUBES);
  }

  @Test
  void aRobotThatForgetsTheTubeInWhichItDrivesIsFound() {
    Visits.assertFinds(
        new StateSearch<>(
            new TubeStates(Visits.bounds(TubeStates.SPACE, "robots=2 placed=1 crashes=1")) {
              @Override
              Optional<TubeVoter.Note> read(String key, TubeVoter.@Nullable Note note) {
                return super.read(key, note)
                    .map(stored -> key.equals(TubeClaims.OWN) ? firstOf(stored) : stored);
              }
            }),
        TubesSpec.INSIDE);
  }

  private static TubeVoter.Note firstOf(TubeVoter.Note note) {
    Holding all = note.holding();
    List<Tube> first = all.held().subList(0, 1);
    return new TubeVoter.Note(new Holding(all.version(), first, all.wanted()), false);
  }
}

package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Outcome;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexStates.Shape;

/** Exhaustive exploration of the code, not of the model, on small instances. */
class MutexExplorationTest {

  private static final ProcessId A = ProcessId.first(new RobotId("a"), 1);
  private static final ProcessId B = ProcessId.first(new RobotId("b"), 1);
  private static final ProcessId C = ProcessId.first(new RobotId("c"), 1);
  private static final View BOTH = View.closed(List.of(A, B));
  private static final List<View> THREE = List.of(View.closed(List.of(A, B, C)));
  private static final int MOST_STATES = 2_000_000;
  private static final List<List<String>> ONE_OR_TWO = List.of(List.of("x"), List.of("x", "y"));

  private static final List<List<String>> MODES = MutexStates.MODES.get(1);
  private static final List<List<String>> TWO_PLACES = List.of(List.of("x/e*2"));

  @Test
  void twoMembersAndTwoSections() {
    Shape shape = new Shape(List.of(BOTH), ONE_OR_TWO, 1, true, 0);
    assertHolds(shape, MutexProtocol::new);
  }

  @Test
  void twoMembersAndTwoRequestsEach() {
    Shape shape = new Shape(List.of(BOTH), List.of(List.of("x")), 2, true, 0);
    assertHolds(shape, MutexProtocol::new);
  }

  @Test
  void aMemberAndAJoinerThatItMayNotKnow() {
    assertHolds(joiner(), MutexProtocol::new);
  }

  @Test
  void twoMembersWithASuspicion() {
    assertHolds(new Shape(List.of(BOTH), List.of(List.of("x")), 1, false, 1), MutexProtocol::new);
  }

  @Test
  void twoMembersOfWhichOneCrashesAndIsSuspected() {
    Shape shape = new Shape(List.of(BOTH), List.of(List.of("x")), 1, 2, true, 1, 1);
    assertHolds(shape, MutexProtocol::new);
  }

  @Test
  @Tag("long")
  void threeMembersOfWhichOneCrashes() {
    assertHolds(new Shape(THREE, List.of(List.of("x")), 1, 3, false, 0, 1), MutexProtocol::new);
  }

  @Test
  @Tag("long")
  void threeMembersThatMayWithdraw() {
    assertHolds(new Shape(THREE, List.of(List.of("x")), 1, 3, true, 0, 0), MutexProtocol::new);
  }

  @Test
  @Tag("long")
  void threeMembersOfWhichOneIsSuspectedAndOneCrashes() {
    assertHolds(new Shape(THREE, List.of(List.of("x")), 1, 2, false, 1, 1), MutexProtocol::new);
  }

  @Test
  @Tag("long")
  void twoOfThreeMembersAndTwoSections() {
    assertHolds(new Shape(THREE, ONE_OR_TWO, 1, 2, true, 0, 0), MutexProtocol::new);
  }

  @Test
  void twoSequences() {
    assertHolds(sequences(), MutexProtocol::new);
  }

  @Test
  void twoMembersInTwoModes() {
    assertHolds(new Shape(List.of(BOTH), MODES, 2, false, 0), MutexProtocol::new);
  }

  @Test
  @Tag("long")
  void threeMembersInTwoModesOfWhichOneHasTwoPlaces() {
    assertHolds(new Shape(THREE, MODES, 1, 3, false, 0, 0), MutexProtocol::new);
  }

  @Test
  void threeMembersAtTwoPlaces() {
    assertHolds(places(), MutexProtocol::new);
  }

  @Test
  @Tag("long")
  void membersAndAJoinerAtTwoPlaces() {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>(Map.of(A, 1L, B, 1L, C, 2L));
    List<View> views = List.of(BOTH, new View(2, admitted));
    assertHolds(new Shape(views, TWO_PLACES, 1, false, 0), MutexProtocol::new);
  }

  @Test
  void twoMembersOfWhichOneCrashesInAMode() {
    assertHolds(new Shape(List.of(BOTH), MODES, 1, 2, false, 1, 1), MutexProtocol::new);
  }

  @Test
  void notCountingTheEarlierOnesIsFound() {
    Outcome outcome = explore(places(), Uncounted::new);
    assertThat(outcome.violation()).last().asString().startsWith("mutex.Capacity");
  }

  private static Shape places() {
    return new Shape(THREE, TWO_PLACES, 1, 3, false, 0, 0);
  }

  @Test
  void consentWithoutAskingWhichOneIsEarlierIsFound() {
    Outcome outcome = explore(sequences(), Polite::new);
    assertThat(outcome.violation()).last().asString().startsWith("mutex.Promise");
  }

  @Test
  void consentToAHeldSectionIsFound() {
    Outcome outcome = explore(sequences(), Careless::new);
    assertThat(outcome.violation()).last().asString().startsWith("mutex.Promise");
  }

  @Test
  void grantingAfterAFenceIsFoundWithItsSteps() {
    Shape shape = new Shape(List.of(BOTH), List.of(List.of("x")), 1, true, 2);
    Outcome outcome = explore(shape, Unfenced::new);
    assertThat(outcome.violation()).last().asString().startsWith("mutex.Kept");
  }

  @Test
  void aMutantIsFoundWithItsSteps() {
    Outcome outcome = explore(joiner(), Deaf::new);
    assertThat(outcome.violation()).last().asString().startsWith("mutex.Exclusive");
    assertThat(outcome.violation()).anyMatch(line -> line.startsWith("b learns view 2"));
  }

  private static Shape joiner() {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    admitted.put(A, 1L);
    admitted.put(B, 2L);
    List<View> views = List.of(View.closed(List.of(A)), new View(2, admitted));
    return new Shape(views, List.of(List.of("x")), 2, false, 0);
  }

  private static Shape sequences() {
    return new Shape(List.of(BOTH), MutexStates.SEQUENCES, true, 1, 2, false, 0, 0);
  }

  private static Outcome explore(Shape shape, MutexNode.Kind kind) {
    return new StateSearch<>(new MutexStates(shape, kind)).run(MOST_STATES, states -> {});
  }

  private static void assertHolds(Shape shape, MutexNode.Kind kind) {
    Outcome outcome = explore(shape, kind);
    assertThat(outcome.violation()).isEmpty();
    assertThat(outcome.isComplete()).isTrue();
    assertThat(outcome.reached()).isPositive();
  }

  /** Never asks back a participant outside its view. */
  private static final class Deaf extends MutexProtocol {
    Deaf(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    void noteHeard(ProcessId other, long otherAdmittedBy) {
      // It uses the view only.
    }
  }

  /** Grants requests of fenced participants. */
  private static final class Unfenced extends MutexProtocol {
    Unfenced(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean refuses(ProcessId peer) {
      return false;
    }
  }

  /** Lets all others go first. */
  private static final class Polite extends MutexProtocol {
    Polite(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean comesBefore(MutexMessage.Req req) {
      return false;
    }
  }

  /** Takes it for consent that another one has a place. */
  private static final class Uncounted extends MutexProtocol {
    Uncounted(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean hasConsents(String section) {
      return missing().stream().allMatch(other -> isCounted(other, section));
    }
  }

  /** Consents to what it holds. */
  private static final class Careless extends MutexProtocol {
    Careless(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean defers(MutexMessage.Req req, String section) {
      return !held().contains(section) && super.defers(req, section);
    }
  }
}

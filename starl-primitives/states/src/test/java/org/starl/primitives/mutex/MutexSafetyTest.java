package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexWorld.Shape;
import org.starl.primitives.mutex.MutexWorld.ViewFault;

/** Safety in the whole envelope; every mutant of the model is found. */
@Tag("long")
class MutexSafetyTest {

  private static final int STEPS = 400;

  private static final Shape CLOSED = new Shape(3, 0, 2, 0, 0, ViewFault.NONE);
  private static final Shape OPEN = new Shape(2, 3, 2, 0, 0, ViewFault.NONE);
  private static final Shape HARSH = new Shape(3, 3, 3, 2, 4, ViewFault.NONE);

  @Test
  void aClosedGroupKeepsItsInvariants() {
    assertSafe(CLOSED, 1_000, 10);
  }

  @Test
  void anOpenGroupKeepsItsInvariants() {
    assertSafe(OPEN, 1_500, 10);
  }

  @Test
  void crashesRestartsAndWrongSuspicionsKeepTheInvariants() {
    assertThat(assertSafe(HARSH, 1_500, 1)).as("confinements").isGreaterThan(400);
  }

  @Test
  void mutualSuspicionKeepsTheInvariants() {
    assertThat(assertSafe(new Shape(2, 1, 1, 0, 6, ViewFault.NONE), 1_500, 1)).isGreaterThan(400);
  }

  @Test
  void modesKeepTheInvariants() {
    assertSafe(OPEN.with("/e", "/w", ""), 1_000, 10);
    assertThat(assertSafe(HARSH.with("/e", "/w"), 1_000, 1)).isGreaterThan(100);
  }

  @Test
  void capacitiesKeepTheInvariants() {
    Shape many = new Shape(4, 2, 1, 0, 0, ViewFault.NONE);
    assertSafe(many.with("/e*2"), 1_500, 4);
    assertSafe(many.with("/e*3", "/w"), 1_000, 4);
    assertThat(
            assertSafe(
                new Shape(4, 3, 2, 2, 4, ViewFault.NONE).with("/e*2", "/e*2", "/w"), 1_500, 1))
        .isGreaterThan(100);
  }

  @Test
  void notCountingTheEarlierOnesIsFound() {
    assertFound(
        "mutex.Capacity", new Shape(4, 0, 1, 0, 0, ViewFault.NONE).with("/e*2"), Uncounted::new);
  }

  @Test
  void notCountingGhostsIsFound() {
    assertFound(
        "mutex.Capacity", new Shape(4, 0, 1, 1, 4, ViewFault.NONE).with("/e*2"), GhostBlind::new);
  }

  @Test
  void lettingAnEarlierNewcomerIntoASectionWithACapacityIsFound() {
    assertFound(
        "mutex.Capacity", new Shape(2, 3, 1, 0, 0, ViewFault.NONE).with("/e*2"), Uncounting::new);
  }

  @Test
  void grantingWithoutAskingIsFound() {
    assertFound("mutex.Exclusive", CLOSED, Unasked::new);
  }

  @Test
  void aJoinerThatIsNotAskedBackIsFound() {
    assertFound("mutex.Exclusive", OPEN, JoinerNotAsked::new);
  }

  @Test
  void countingAnAnswerToAnotherRequestIsFound() {
    assertFound("mutex.Exclusive", CLOSED, ReplyWithoutId::new);
  }

  @Test
  void aClockThatDoesNotAdvanceIsFound() {
    assertFound("mutex.Exclusive", CLOSED, NoClockUpdate::new);
  }

  @Test
  void aHolderThatAnswersByItsClockIsFound() {
    assertFound("mutex.Exclusive", OPEN, CriticalAnswers::new);
  }

  @Test
  void continuingAfterARemovalIsFound() {
    assertFound("mutex.Kept", new Shape(2, 1, 1, 0, 3, ViewFault.NONE), OutGoesOn::new);
  }

  @Test
  void aFencerThatGoesOnGrantingIsFound() {
    assertFound("mutex.Kept", new Shape(3, 0, 2, 0, 4, ViewFault.NONE), Unfenced::new);
    assertFound("mutex.Exclusive", new Shape(3, 0, 1, 0, 6, ViewFault.NONE), Unfenced::new);
  }

  @Test
  void forgettingAFencedParticipantWithoutAViewIsFound() {
    assertFound(
        "mutex.Exclusive", new Shape(2, 0, 1, 0, 4, ViewFault.NONE), ExclusionWithoutView::new);
  }

  @Test
  void aFenceWithoutNeededConsentIsFound() {
    assertFound("mutex.Kept", new Shape(2, 2, 1, 0, 4, ViewFault.NONE), FencerNeverAsked::new);
  }

  @Test
  void aFenceThatCountsAfterItsFencerHasLeftIsFound() {
    Shape shape = new Shape(2, 1, 1, 0, 6, ViewFault.FENCER_GONE);
    assertFound("mutex.Kept", shape, MutexProtocol::new);
  }

  @Test
  void enteringASectionOfAGhostIsFound() {
    assertFound("mutex.Exclusive", new Shape(3, 0, 1, 1, 4, ViewFault.NONE), GhostBlind::new);
  }

  @Test
  void aViewThatOmitsAMemberIsFound() {
    assertFound("mutex.Exclusive", OPEN.with(ViewFault.LOSES_A_MEMBER), MutexProtocol::new);
  }

  @Test
  void admittingAnIdTwiceIsFound() {
    Shape shape = new Shape(3, 1, 1, 0, 2, ViewFault.READMITS);
    assertFound("mutex.Exclusive", shape, MutexProtocol::new);
  }

  @Test
  void aRestartUnderTheOldIdIsFound() {
    Shape shape = new Shape(3, 0, 1, 2, 0, ViewFault.RESTARTS_UNDER_THE_OLD_ID);
    assertFound("mutex.Exclusive", shape, MutexProtocol::new);
  }

  /** Returns the number of confined participants. */
  private static long assertSafe(Shape shape, int seeds, int entriesPerRun) {
    long entries = 0;
    long confinements = 0;
    for (long seed = 0; seed < seeds; seed++) {
      MutexWorld world = new MutexWorld(shape, MutexProtocol::new, seed);
      assertThat(world.run(STEPS)).as("seed %d of %s", seed, shape).isEmpty();
      assertThat(world.monitors.report().violations())
          .as("what the monitors say of seed %d of %s", seed, shape)
          .isEmpty();
      entries += world.entries;
      confinements += world.confinements;
    }
    assertThat(entries)
        .as("runs in which hardly anybody enters show little")
        .isGreaterThan((long) seeds * entriesPerRun);
    return confinements;
  }

  /** The oracle and the monitors must both find the mutant in one of many runs. */
  private static void assertFound(String lemma, Shape shape, MutexNode.Kind mutant) {
    long bySight = 0;
    for (long seed = 0; seed < 5_000; seed++) {
      MutexWorld world = new MutexWorld(shape, mutant, seed);
      if (world.run(STEPS, lemma).isPresent()) {
        bySight++;
        world.run(STEPS, "no invariant");
        if (world.monitors.report().violations(lemma) > 0) {
          return;
        }
      }
    }
    throw new AssertionError(
        "the mutant breaks nothing; but for the oracle, " + bySight + " times");
  }

  private static class Uncounted extends MutexProtocol {
    Uncounted(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean hasConsents(String section) {
      return missing().stream().allMatch(other -> isCounted(other, section));
    }
  }

  private static class Uncounting extends MutexProtocol {
    Uncounting(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean counts(MutexMessage.Req req, String section) {
      return wanted().contains(section);
    }
  }

  private static class Unasked extends MutexProtocol {
    Unasked(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean hasConsents(String section) {
      return true;
    }
  }

  private static class JoinerNotAsked extends MutexProtocol {
    JoinerNotAsked(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    void noteHeard(ProcessId other, long otherAdmittedBy) {
      // It uses the view only.
    }
  }

  private static class ReplyWithoutId extends MutexProtocol {
    ReplyWithoutId(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean answersMyRequest(MutexMessage.Ok ok) {
      return true;
    }
  }

  private static class NoClockUpdate extends MutexProtocol {
    NoClockUpdate(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    void witness(long otherTs) {
      // Its clock counts only its own requests.
    }
  }

  private static class CriticalAnswers extends MutexProtocol {
    CriticalAnswers(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean defers(MutexMessage.Req req, String section) {
      return super.defers(req, section) && isBefore(ts(), me(), req.ts(), req.from());
    }
  }

  private static class OutGoesOn extends MutexProtocol {
    OutGoesOn(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    void removed() {
      // It continues as if the view still listed it.
    }
  }

  private static class Unfenced extends MutexProtocol {
    Unfenced(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean refuses(ProcessId peer) {
      return false;
    }
  }

  private static class ExclusionWithoutView extends MutexProtocol {
    ExclusionWithoutView(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    boolean hasConsents(String section) {
      SortedSet<ProcessId> needed = new TreeSet<>(missing());
      needed.removeAll(fenced());
      return needed.isEmpty();
    }
  }

  private static class FencerNeverAsked extends MutexProtocol {
    FencerNeverAsked(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    public boolean hasSayOver(ProcessId suspect, long itsAdmittedBy) {
      return mayRequest();
    }
  }

  private static class GhostBlind extends MutexProtocol {
    GhostBlind(Self self, MutexEffects effects) {
      super(self, effects);
    }

    @Override
    Stream<Map.Entry<ProcessId, View.Ghost>> ghosts() {
      return Stream.empty();
    }
  }
}

package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.ProcessId;
import org.starl.comms.LamportClock;
import org.starl.primitives.mutex.MutexWorld.Shape;
import org.starl.primitives.mutex.MutexWorld.ViewFault;

/** Safety under the whole envelope; and each of the model's mutants is found. */
class MutexSafetyTest {

  private static final int STEPS = 400;

  private static final Shape CLOSED = new Shape(3, 0, 2, 0, 0, ViewFault.NONE);
  private static final Shape OPEN = new Shape(2, 3, 2, 0, 0, ViewFault.NONE);
  private static final Shape HARSH = new Shape(3, 3, 3, 1, 2, ViewFault.NONE);

  @Test
  void aClosedGroupKeepsItsInvariants() {
    assertSafe(CLOSED, 1_000, 10);
  }

  @Test
  void anOpenGroupKeepsItsInvariants() {
    assertSafe(OPEN, 1_500, 10);
  }

  @Test
  void crashesAndExclusionsKeepTheInvariants() {
    assertSafe(HARSH, 1_500, 1);
  }

  @Test
  void grantingWithoutAskingIsFound() {
    assertFound("Exclusive", CLOSED, Unasked::new);
  }

  @Test
  void aJoinerThatIsNotAskedBackIsFound() {
    assertFound("Exclusive", OPEN, JoinerNotAsked::new);
  }

  @Test
  void anAnswerToAnotherRequestIsFound() {
    assertFound("Exclusive", CLOSED, ReplyWithoutId::new);
  }

  @Test
  void aClockThatDoesNotHearIsFound() {
    assertFound("Exclusive", CLOSED, NoClockUpdate::new);
  }

  @Test
  void aHolderThatAnswersByItsClockIsFound() {
    assertFound("Exclusive", OPEN, CriticalAnswers::new);
  }

  @Test
  void whoGoesOnAfterItsExclusionIsFound() {
    assertFound("Exclusive", new Shape(3, 1, 1, 0, 2, ViewFault.NONE), OutGoesOn::new);
  }

  @Test
  void aListThatForgetsAMemberIsFound() {
    assertFound("Exclusive", withFault(OPEN, ViewFault.LOSES_A_MEMBER), MutexProtocol::new);
  }

  @Test
  void anIdThatIsAdmittedAgainIsFound() {
    Shape shape = new Shape(3, 1, 1, 0, 2, ViewFault.READMITS);
    assertFound("Exclusive", shape, MutexProtocol::new);
  }

  @Test
  void aRestartUnderTheOldIdIsFound() {
    Shape shape = new Shape(3, 0, 1, 2, 0, ViewFault.RESTARTS_UNDER_THE_OLD_ID);
    assertFound("Exclusive", shape, MutexProtocol::new);
  }

  private static Shape withFault(Shape shape, ViewFault fault) {
    return new Shape(
        shape.members(),
        shape.joiners(),
        shape.sections(),
        shape.crashes(),
        shape.exclusions(),
        fault);
  }

  private static void assertSafe(Shape shape, int seeds, int entriesPerRun) {
    long entries = 0;
    for (long seed = 0; seed < seeds; seed++) {
      MutexWorld world = new MutexWorld(shape, MutexProtocol::new, seed);
      assertThat(world.run(STEPS)).as("seed %d of %s", seed, shape).isEmpty();
      assertThat(world.monitors.report().violations())
          .as("what the monitors say of seed %d of %s", seed, shape)
          // Who is put out while it is up is unknown to them.
          .filteredOn(found -> shape.exclusions() == 0 || !found.lemma().equals("Connected"))
          .isEmpty();
      entries += world.entries;
    }
    assertThat(entries)
        .as("runs in which hardly anybody enters show little")
        .isGreaterThan((long) seeds * entriesPerRun);
  }

  /** Both the oracle and the monitors must see it, in one of many runs. */
  private static void assertFound(String lemma, Shape shape, MutexNode.Kind mutant) {
    for (long seed = 0; seed < 5_000; seed++) {
      MutexWorld world = new MutexWorld(shape, mutant, seed);
      if (world.run(STEPS, lemma).isPresent()) {
        assertThat(world.monitors.report().violations(lemma)).as("seed %d", seed).isPositive();
        return;
      }
    }
    throw new AssertionError("the mutant breaks nothing");
  }

  private static class Unasked extends MutexProtocol {
    Unasked(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
      super(me, clock, times, effects);
    }

    @Override
    boolean hasAllAnswers() {
      return true;
    }
  }

  private static class JoinerNotAsked extends MutexProtocol {
    JoinerNotAsked(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
      super(me, clock, times, effects);
    }

    @Override
    void noteHeard(ProcessId other, long otherAdmittedBy) {
      // The view only.
    }
  }

  private static class ReplyWithoutId extends MutexProtocol {
    ReplyWithoutId(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
      super(me, clock, times, effects);
    }

    @Override
    boolean answersMyRequest(MutexMessage.Ok ok) {
      return true;
    }
  }

  private static class NoClockUpdate extends MutexProtocol {
    NoClockUpdate(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
      super(me, clock, times, effects);
    }

    @Override
    void witness(long otherTs) {
      // Its clock counts its own requests only.
    }
  }

  private static class CriticalAnswers extends MutexProtocol {
    CriticalAnswers(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
      super(me, clock, times, effects);
    }

    @Override
    boolean keepsBack(MutexMessage.Req req) {
      return super.keepsBack(req) && isBefore(ts(), me(), req.ts(), req.from());
    }
  }

  private static class OutGoesOn extends MutexProtocol {
    OutGoesOn(ProcessId me, LamportClock clock, MutexTimes times, Effects effects) {
      super(me, clock, times, effects);
    }

    @Override
    void removed() {
      // As if it still stood in the view.
    }
  }
}

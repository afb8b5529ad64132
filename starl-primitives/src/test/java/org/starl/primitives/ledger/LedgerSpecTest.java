package org.starl.primitives.ledger;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.ledger.Seen.A;
import static org.starl.primitives.ledger.Seen.ADD;
import static org.starl.primitives.ledger.Seen.B;
import static org.starl.primitives.ledger.Seen.BEGIN_A;
import static org.starl.primitives.ledger.Seen.CLAIM_A;
import static org.starl.primitives.ledger.Seen.FINISH_A;
import static org.starl.primitives.ledger.Seen.FREE;
import static org.starl.primitives.ledger.Seen.PA;
import static org.starl.primitives.ledger.Seen.PA2;
import static org.starl.primitives.ledger.Seen.PB;
import static org.starl.primitives.ledger.Seen.REOPEN;
import static org.starl.primitives.ledger.Seen.START_A;
import static org.starl.primitives.ledger.Seen.START_B;
import static org.starl.primitives.ledger.Seen.T;
import static org.starl.primitives.ledger.Seen.acts;
import static org.starl.primitives.ledger.Seen.applies;
import static org.starl.primitives.ledger.Seen.asks;
import static org.starl.primitives.ledger.Seen.installs;
import static org.starl.primitives.ledger.Seen.isTold;
import static org.starl.primitives.ledger.Seen.votes;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.ledger.LedgerEntry.Begin;
import org.starl.primitives.ledger.LedgerEntry.Claim;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

class LedgerSpecTest {

  private static final RobotId C = new RobotId("c");
  private static final SortedSet<TaskId> NONE = new TreeSet<>();
  private static final long MS = 1_000_000;
  private static final long BOUND_NS = 100;
  private static final long FREED_NS = 500;

  private final Monitors monitors = new Monitors(List.of(new LedgerSpec(BOUND_NS, FREED_NS)));

  private void sees(TraceEvent... events) {
    for (TraceEvent event : events) {
      monitors.observe(event);
    }
  }

  private long violations(String lemma) {
    return monitors.report().violations(lemma);
  }

  @Test
  void oneTaskFromItsAddToItsFinishHolds() {
    sees(
        votes(0, A),
        asks(1, A, ADD),
        applies(2, A, 1, 1, START_A, ADD, CLAIM_A),
        isTold(2, A, ADD, LedgerOutcome.DONE),
        applies(3, B, 1, 1, START_A, ADD, CLAIM_A),
        applies(4, A, 2, 1, BEGIN_A),
        isTold(4, A, BEGIN_A, LedgerOutcome.DONE),
        applies(5, A, 3, 0, FINISH_A),
        isTold(5, A, FINISH_A, LedgerOutcome.DONE),
        installs(6, B, 3, 0));
    monitors.finish(1_000);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
  }

  @Test
  void aCallThatIsGivenUpBeforeTheDeadlineViolatesAnswered() {
    for (long toldNs : List.of(3 * MS, 3 * MS - 1)) {
      LedgerSettings settings = new LedgerSettings(SynodTiming.DEFAULT, 1, 2, 3);
      LedgerSpec spec = new LedgerSpec(10 * MS, 10 * MS).patient(settings);
      Monitors patient = new Monitors(List.of(spec));
      patient.observe(asks(0, A, ADD));
      patient.observe(isTold(toldNs, A, ADD, LedgerOutcome.UNKNOWN));
      assertThat(patient.report().violations(LedgerSpec.ANSWERED)).isEqualTo(3 * MS - toldNs);
    }
  }

  private static Monitors patient() {
    LedgerSettings settings = new LedgerSettings(SynodTiming.DEFAULT, 1, 2, 3);
    return new Monitors(List.of(new LedgerSpec(10 * MS, 10 * MS).patient(settings)));
  }

  /** The lease is of 2 ms. */
  @Test
  void aClaimThatIsEndedBeforeItsLeaseViolatesSuspected() {
    for (long silentNs : List.of(2 * MS, 2 * MS - 1)) {
      Monitors patient = patient();
      patient.observe(applies(1, A, 1, 1, START_B, ADD, new Claim(T, 1, PB)));
      patient.observe(Seen.hears(5, A, new LedgerMessage.Here(PB, 1, false)));
      patient.observe(Seen.prepares(5 + silentNs, A, FREE));
      patient.observe(Seen.prepares(6 + silentNs, A, FREE)); // its wish of before
      assertThat(patient.report().checks(LedgerSpec.SUSPECTED)).isEqualTo(2);
      assertThat(patient.report().violations(LedgerSpec.SUSPECTED)).isEqualTo(2 * MS - silentNs);
    }
  }

  /** A vote for decree 2: the voter has decree 1. */
  @Test
  void aVoterThatWishesToEndTheClaimOfABegunTaskViolatesBegunByOne() {
    sees(applies(1, A, 1, 1, START_A, ADD, CLAIM_A), applies(2, A, 2, 1, BEGIN_A));
    sees(Seen.prepares(3, B, FREE));
    assertThat(violations(LedgerSpec.BEGUN_BY_ONE)).isZero();
    Monitors informed = new Monitors(List.of(new LedgerSpec(BOUND_NS, FREED_NS)));
    informed.observe(applies(1, A, 1, 1, START_A, ADD, CLAIM_A, BEGIN_A));
    informed.observe(Seen.prepares(3, B, FREE));
    assertThat(informed.report().violations(LedgerSpec.BEGUN_BY_ONE)).isEqualTo(1);
  }

  @Test
  void aRobotThatAsksAndIsNotToldViolatesBehind() {
    for (long number : List.of(1L, 2L)) {
      for (boolean asks : List.of(true, false)) {
        Monitors patient = patient();
        patient.observe(installs(0, A, 1, 0)); // it need not have what it has not applied
        patient.observe(applies(1, A, 2, 0));
        patient.observe(Seen.hears(5, A, new LedgerMessage.Here(PB, number - 1, asks)));
        patient.observe(Seen.decrees(5, A, B, 1));
        patient.observe(Seen.decrees(6, A, B, 2));
        boolean isDue = asks && number == 2;
        assertThat(patient.report().checks(LedgerSpec.BEHIND)).isEqualTo(isDue ? 1 : 0);
        assertThat(patient.report().violations(LedgerSpec.BEHIND)).isEqualTo(isDue ? 1 : 0);
      }
    }
    Monitors patient = patient();
    patient.observe(applies(1, A, 2, 0));
    patient.observe(Seen.hears(5, A, new LedgerMessage.Here(PB, 1, true)));
    patient.observe(Seen.decrees(5, A, B, 2));
    patient.observe(Seen.decrees(6, A, B, 3));
    assertThat(patient.report().violations(LedgerSpec.BEHIND)).isZero();
  }

  @Test
  void whoDecidesADecreeAndTellsNotAllVotersViolatesBehind() {
    for (long toldNs : List.of(5L, 6L)) {
      Monitors patient = patient();
      patient.observe(votes(0, A));
      patient.observe(Seen.hearsVote(5, A, B, 1));
      patient.observe(applies(5, A, 1, 0));
      patient.observe(Seen.decrees(toldNs, A, B, 1));
      patient.observe(applies(7, B, 1, 0)); // it is told, and decides nothing
      patient.observe(installs(8, B, 1, 0));
      assertThat(patient.report().violations(LedgerSpec.BEHIND)).isEqualTo(toldNs - 5);
    }
  }

  @Test
  void aVoterThatIsNotAskedInItsTurnViolatesBehind() {
    Monitors patient = patient();
    patient.observe(votes(0, A));
    for (boolean asks : List.of(true, false, true, false)) {
      patient.observe(Seen.beacons(1, A, B, asks));
    }
    assertThat(patient.report().violations(LedgerSpec.BEHIND)).isZero();
    patient.observe(Seen.beacons(2, A, B, false));
    assertThat(patient.report().violations(LedgerSpec.BEHIND)).isEqualTo(1);
  }

  @Test
  void whatAnEarlierProgramOfARobotWantedViolatesPresent() {
    LedgerEntry again = new LedgerEntry.Start(PA2);
    sees(applies(1, A, 1, 1, START_A, ADD, CLAIM_A, BEGIN_A, again));
    assertThat(violations(LedgerSpec.PRESENT)).isZero();
    sees(applies(2, A, 2, 0, FINISH_A));
    assertThat(violations(LedgerSpec.PRESENT)).isEqualTo(1);
    sees(applies(3, A, 3, 1, START_A));
    assertThat(violations(LedgerSpec.PRESENT)).isEqualTo(2);
    Monitors late = new Monitors(List.of(new LedgerSpec(BOUND_NS, FREED_NS)));
    late.observe(applies(1, A, 1, 1, START_A, ADD, again, CLAIM_A));
    assertThat(late.report().violations(LedgerSpec.PRESENT)).isEqualTo(1);
  }

  @Test
  void otherEntriesAtOneNumberViolateOneLog() {
    sees(applies(1, A, 1, 1, ADD), applies(2, B, 1, 0));
    assertThat(violations(LedgerSpec.ONE_LOG)).isEqualTo(1);
  }

  /** A slow carrier that trusts its clock: its claim has ended. */
  @Test
  void aRobotThatIsToldToDoWhatAnotherHasBegunViolatesBegunByOne() {
    Claim second = new Claim(T, 2, PB);
    Begin begin = new Begin(T, 2, PB);
    sees(applies(1, B, 1, 1, START_A, START_B, ADD, CLAIM_A, FREE, second, begin));
    assertThat(monitors.report().holds()).isTrue();
    sees(isTold(2, B, begin, LedgerOutcome.DONE));
    assertThat(monitors.report().holds()).isTrue();
    sees(isTold(2, A, BEGIN_A, LedgerOutcome.DONE));
    assertThat(violations(LedgerSpec.BEGUN_BY_ONE)).isEqualTo(1);
  }

  @Test
  void aBegunTaskThatIsClaimedAgainViolatesBegunByOneUnlessItWasReopened() {
    sees(
        applies(1, A, 1, 1, START_A, START_B, ADD, CLAIM_A, BEGIN_A, REOPEN),
        applies(1, A, 2, 1, new Claim(T, 2, PB)));
    assertThat(monitors.report().holds()).isTrue();
    sees(applies(1, A, 3, 1, new Begin(T, 2, PB), new Claim(T, 3, PB)));
    assertThat(violations(LedgerSpec.BEGUN_BY_ONE)).isEqualTo(1);
  }

  @Test
  void aSecondFinishViolatesFinishedOnce() {
    sees(applies(1, A, 1, 0, START_A, ADD, CLAIM_A, BEGIN_A, FINISH_A));
    assertThat(monitors.report().holds()).isTrue();
    sees(applies(2, A, 2, -1, FINISH_A));
    assertThat(violations(LedgerSpec.FINISHED_ONCE)).isEqualTo(1);
  }

  /** A restarted carrier that believes that it has delivered. */
  @Test
  void aRobotThatIsToldThatAnOpenTaskIsFinishedViolatesFinishedOnce() {
    sees(
        applies(1, A, 1, 1, START_A, ADD, CLAIM_A, BEGIN_A),
        isTold(1, A, FINISH_A, LedgerOutcome.DONE));
    assertThat(violations(LedgerSpec.FINISHED_ONCE)).isEqualTo(1);
  }

  @Test
  void aTaskThatIsMissingViolatesKept() {
    sees(applies(1, A, 1, 1, ADD), installs(2, B, 1, 0));
    assertThat(violations(LedgerSpec.KEPT)).isEqualTo(1);
  }

  @Test
  void aTaskThatIsSaidToBeAddedAndIsNotViolatesKept() {
    sees(applies(1, A, 1, 0, START_A), isTold(2, A, ADD, LedgerOutcome.DONE));
    assertThat(violations(LedgerSpec.KEPT)).isEqualTo(1);
  }

  @Test
  void aRobotThatIsToldThatItHasTheClaimOfAnotherViolatesTold() {
    Claim late = new Claim(T, 1, PB);
    sees(
        applies(1, A, 1, 1, START_A, START_B, ADD, CLAIM_A),
        isTold(2, A, CLAIM_A, LedgerOutcome.DONE),
        isTold(2, B, late, LedgerOutcome.LATE));
    assertThat(violations(LedgerSpec.TOLD)).isZero();
    sees(isTold(3, B, late, LedgerOutcome.DONE));
    assertThat(violations(LedgerSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aRobotThatIsToldThatAClaimHasEndedWhichStandsViolatesTold() {
    sees(
        applies(1, A, 1, 1, START_A, ADD, CLAIM_A, FREE),
        isTold(1, A, FREE, LedgerOutcome.DONE),
        applies(2, A, 2, 1, new Claim(T, 2, PA), new Begin(T, 2, PA)),
        isTold(2, A, FREE, LedgerOutcome.DONE));
    assertThat(violations(LedgerSpec.TOLD)).isZero();
    sees(isTold(2, A, new LedgerEntry.Reopen(T, 2), LedgerOutcome.DONE));
    sees(isTold(2, A, new LedgerEntry.Free(T, 2), LedgerOutcome.DONE));
    assertThat(violations(LedgerSpec.TOLD)).isEqualTo(2);
  }

  @Test
  void aRobotThatGivesBackTheClaimOfAnotherViolatesTold() {
    sees(applies(1, A, 1, 1, START_A, ADD, CLAIM_A), asks(2, A, FREE));
    sees(asks(2, B, new LedgerEntry.Free(T, 0))); // none of its own
    assertThat(violations(LedgerSpec.TOLD)).isZero();
    sees(asks(2, B, FREE));
    assertThat(violations(LedgerSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void heldFollowsTheLogThatTheRobotHas() {
    sees(
        installs(0, A, 0, 0),
        shows(0, LedgerFact.READY, false),
        shows(0, LedgerFact.HELD, NONE),
        applies(1, A, 1, 1, START_A, ADD),
        shows(1, LedgerFact.READY, true),
        applies(2, A, 2, 1, CLAIM_A),
        shows(2, LedgerFact.HELD, new TreeSet<>(List.of(T))),
        applies(3, A, 3, 1, BEGIN_A),
        new Fault(4, A, Fault.CRASH, ""),
        shows(5, LedgerFact.READY, false),
        shows(5, LedgerFact.HELD, NONE),
        installs(5, A, 3, 1),
        applies(6, A, 4, 1, new LedgerEntry.Start(PA2)),
        shows(6, LedgerFact.READY, true),
        shows(6, LedgerFact.HELD, new TreeSet<>(List.of(T))),
        applies(7, A, 5, 0, new LedgerEntry.Finish(T, 1, PA2)));
    assertThat(monitors.report().violations()).isEmpty();
    assertThat(monitors.report().checks(LedgerSpec.HELD)).isPositive();
    sees(applies(8, A, 6, 0)); // it still shows the finished task
    assertThat(violations(LedgerSpec.HELD)).isEqualTo(1);
  }

  @Test
  void aRobotThatIsReadyBeforeItsStartIsInTheLogViolatesHeld() {
    sees(installs(0, A, 0, 0), shows(0, LedgerFact.READY, true));
    assertThat(violations(LedgerSpec.HELD)).isEqualTo(1);
  }

  private static <V> Variable shows(long timeNs, Var<V> variable, V value) {
    return new Variable(timeNs, A, Seen.SOURCE, variable, value);
  }

  @Test
  void aCallWithoutAnAnswerViolatesAnsweredWhileAMajorityIsUp() {
    sees(
        votes(1, A),
        asks(1, A, ADD),
        new Fault(50, B, Fault.CRASH, ""),
        new Fault(300, B, Fault.RESTART, ""));
    assertThat(violations(LedgerSpec.ANSWERED)).isZero();
    monitors.finish(401);
    assertThat(violations(LedgerSpec.ANSWERED)).isEqualTo(1);
  }

  @Test
  void anUnknownOutcomeIsAnAnswer() {
    sees(votes(1, A), asks(1, A, ADD), isTold(99, A, ADD, LedgerOutcome.UNKNOWN));
    monitors.finish(401);
    assertThat(monitors.report().checks(LedgerSpec.ANSWERED)).isEqualTo(1);
    assertThat(violations(LedgerSpec.ANSWERED)).isZero();
  }

  @Test
  void aClaimOfACrashedRobotThatStaysViolatesFreed() {
    sees(
        acts(0, A, LedgerFact.VOTERS, new LedgerFact.Voters(List.of(A, B, C))),
        applies(1, A, 1, 1, START_A, START_B, ADD, new Claim(T, 1, PB)),
        new Fault(10, B, Fault.CRASH, ""),
        new Fault(20, C, Fault.CRASH, ""));
    sees(applies(2_000, A, 2, 1, START_A)); // one of three voters is no majority
    assertThat(violations(LedgerSpec.FREED)).isZero();
    sees(new Fault(3_000, C, Fault.RESTART, ""));
    monitors.finish(3_501);
    assertThat(violations(LedgerSpec.FREED)).isEqualTo(1);
  }

  @Test
  void aClaimThatEndsInTimeIsFreed() {
    sees(
        acts(0, A, LedgerFact.VOTERS, new LedgerFact.Voters(List.of(A, B, C))),
        applies(1, A, 1, 1, START_A, START_B, ADD, new Claim(T, 1, PB)),
        new Fault(10, B, Fault.CRASH, ""),
        applies(510, A, 2, 1, FREE));
    monitors.finish(9_000);
    assertThat(violations(LedgerSpec.FREED)).isZero();
    assertThat(monitors.report().checks(LedgerSpec.FREED)).isEqualTo(1);
  }
}

package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.shape.Shapes;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

class ElectionSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");
  private static final Var<String> LOC = Var.of("loc", Shapes.TEXT);

  private final Monitors monitors = new Monitors(List.of(new ElectionSpec(100, 300)));
  private long nowNs;

  @Test
  void anElectionWithOneLeaderForAllHolds() {
    allTakePart();
    follows(A, leader(1, B), 10);
    follows(B, leader(1, B), 20);
    follows(C, leader(1, B), 30);
    endAt(1_000);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
    assertThat(monitors.report().checks(ElectionSpec.ELECTED)).isEqualTo(3);
    assertThat(monitors.report().checks(ElectionSpec.TOLD)).isEqualTo(3);
  }

  @Test
  void twoLeadersInOneTermViolateAgreement() {
    allTakePart();
    follows(A, leader(1, B), 10);
    follows(B, leader(1, A), 20);
    assertThat(monitors.report().violations(ElectionSpec.AGREEMENT)).isEqualTo(1);
  }

  @Test
  void twoLeadersInTwoTermsHold() {
    allTakePart();
    stands(A, 2);
    follows(A, leader(1, B), 10);
    follows(B, leader(2, A), 20);
    assertThat(monitors.report().violations(ElectionSpec.AGREEMENT)).isZero();
  }

  @Test
  void aLeaderThatWasNoCandidateInItsTermViolatesSoundness() {
    allTakePart();
    follows(A, leader(2, B), 10);
    assertThat(monitors.report().violations(ElectionSpec.SOUNDNESS)).isEqualTo(1);
  }

  @Test
  void aCandidateThatNeverCalledDoElectionViolatesSoundness() {
    exists(A);
    stands(A, 1);
    follows(B, leader(1, A), 10);
    assertThat(monitors.report().violations(ElectionSpec.SOUNDNESS)).isEqualTo(1);
  }

  @Test
  void aCandidateWithoutLeaderWithinTheBoundViolatesElected() {
    allTakePart();
    follows(A, leader(1, B), 10);
    follows(B, leader(1, B), 10);
    endAt(102);
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isEqualTo(1);
  }

  @Test
  void nothingIsOwedWithoutAMajorityOrDuringAFault() {
    allTakePart();
    fault(A, Fault.CRASH, 10);
    fault(B, Fault.CRASH, 10);
    endAt(200);
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isZero();
  }

  @Test
  void afterHealingTheWholeBoundAppliesAgain() {
    allTakePart();
    fault(Fault.WORLD, Fault.BEGIN, 10);
    fault(Fault.WORLD, Fault.HEALED, 150);
    see(new Variable(250, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isZero();
    endAt(251);
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isEqualTo(3);
  }

  @Test
  void aDeadLeaderMustBeReplaced() {
    allTakePart();
    for (RobotId robot : List.of(A, B, C)) {
      follows(robot, leader(1, C), 10);
    }
    fault(C, Fault.CRASH, 20);
    endAt(121);
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isEqualTo(2);
  }

  @Test
  void failEndsTheWaitAndNullBeyondTheDeadlineViolatesTold() {
    allTakePart();
    fault(Fault.WORLD, Fault.BEGIN, 2);
    follows(A, Leader.FAIL, 300);
    follows(B, leader(1, A), 300);
    endAt(302);
    assertThat(monitors.report().violations(ElectionSpec.TOLD)).isEqualTo(1);
    assertThat(monitors.report().checks(ElectionSpec.TOLD)).isEqualTo(3);
  }

  @Test
  void aTermThatBeginsBeforeTheDecisionOfTheOneBeforeViolatesTerms() {
    Monitors patient = patient();
    patient.observe(Seen.stands(1, A, 2, id(A)));
    assertThat(patient.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
    patient.observe(Seen.stands(1, B, 2, id(B))); // as it hears of A
    patient.observe(Seen.tells(1, C, A, new ElectionMessage.Elected(id(C), 2, id(A))));
    patient.observe(Seen.stands(1, C, 3, id(C)));
    assertThat(patient.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
    patient.observe(Seen.shows(10, C, leader(3, C)));
    patient.observe(Seen.stands(10, B, 4, id(B)));
    assertThat(patient.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
  }

  @Test
  void aTermThatGoesBackViolatesTerms() {
    allTakePart();
    stands(A, 2);
    follows(A, leader(1, B), 10);
    assertThat(monitors.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
    fault(A, Fault.CRASH, 20);
    fault(A, Fault.RESTART, 30);
    follows(A, leader(1, B), 40);
    assertThat(monitors.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
  }

  @Test
  void aLiveLeaderThatIsDeposedInCalmViolatesElectedIfLeadersStay() {
    Monitors stay = new Monitors(List.of(new ElectionSpec(100, 300).leaderStays()));
    for (Monitors each : List.of(monitors, stay)) {
      each.observe(Seen.exists(0, 1, id(A)));
      each.observe(Seen.calls(0, A, id(A)));
      each.observe(Seen.stands(0, A, 1, id(A)));
      each.observe(Seen.shows(1, A, leader(1, A)));
      each.observe(Seen.stands(2, A, 2, id(A)));
    }
    assertThat(monitors.report().violations()).isEmpty();
    assertThat(stay.report().violations(ElectionSpec.ELECTED)).isEqualTo(1);
  }

  @Test
  void anOlderLeaderOrAFailureAfterACandidacyViolatesLeader() {
    follows(A, Leader.NONE, 0);
    follows(B, Leader.NONE, 0);
    allTakePart();
    follows(A, leader(1, B), 10);
    follows(B, Leader.FAIL, 10);
    stands(A, 2);
    stands(B, 2);
    follows(A, Leader.NONE, 10);
    assertThat(monitors.report().violations(ElectionSpec.LEADER)).isZero();
    follows(B, Leader.NONE, 11);
    assertThat(monitors.report().violations(ElectionSpec.LEADER)).isEqualTo(1);
    follows(A, leader(2, B), 12);
    nowNs = 13;
    see(Seen.calls(13, A, id(A)));
    follows(A, Leader.FAIL, 13);
    assertThat(monitors.report().violations(ElectionSpec.LEADER)).isEqualTo(2);
  }

  @Test
  void aLeaderThatIsDeposedBeforeItsSilenceViolatesSuspected() {
    long ms = 1_000_000;
    for (long silentMs : List.of(2L, 1L)) {
      Monitors patient = patient();
      patient.observe(Seen.shows(0, A, leader(1, B)));
      patient.observe(Seen.hears(3 * ms, A, new ElectionMessage.Elected(id(B), 1, id(B))));
      patient.observe(Seen.stands((3 + silentMs) * ms, A, 2, id(A)));
      patient.observe(Seen.stands((3 + silentMs) * ms, C, 2, id(C)));
      assertThat(patient.report().checks(ElectionSpec.SUSPECTED)).as("candidacies").isEqualTo(5);
      assertThat(patient.report().violations(ElectionSpec.SUSPECTED)).isEqualTo(2 - silentMs);
    }
  }

  @Test
  void whoDoesNotTellARobotThatIsBehindAtOnceViolatesBehind() {
    ElectionMessage leads = new ElectionMessage.Elected(id(A), 2, id(B));
    ElectionMessage stood = new ElectionMessage.Candidacy(id(A), 1, 1);
    for (ElectionMessage heard :
        List.of(
            new ElectionMessage.Candidacy(id(C), 1, 1), // of the term before
            new ElectionMessage.Elected(id(C), 1, id(C)),
            new ElectionMessage.Candidacy(id(C), 2, 1))) { // does not know the leader
      assertThat(behind(heard, Seen.tells(5, A, C, leads))).isZero();
      assertThat(behind(heard, Seen.tells(5, A, C, stood))).as("an old term").isEqualTo(1);
      assertThat(behind(heard, Seen.tells(5, A, B, leads))).as("another robot").isEqualTo(1);
      assertThat(behind(heard, Seen.tells(5, B, C, leads))).as("by another robot").isEqualTo(1);
      assertThat(behind(heard, Seen.tells(6, A, C, leads))).as("later").isEqualTo(1);
    }
    TraceEvent nothing = new Fault(5, B, Fault.CRASH, "");
    assertThat(behind(new ElectionMessage.Elected(id(C), 2, id(B)), nothing)).isZero();
    assertThat(behind(new ElectionMessage.Candidacy(id(C), 3, 1), nothing)).isZero();
    ElectionMessage dead = new ElectionMessage.Candidacy(ProcessId.first(C, 2), 1, 1);
    assertThat(behind(dead, nothing)).as("of no live program").isZero();
  }

  @Test
  void aNewCandidateThatIsNotToldViolatesBehind() {
    ElectionMessage candidacy = new ElectionMessage.Candidacy(id(C), 1, 1);
    ElectionMessage own = new ElectionMessage.Candidacy(id(A), 1, 2);
    for (long lateNs : List.of(0, 1)) {
      Monitors patient = patient();
      patient.observe(Seen.hears(5, A, candidacy));
      patient.observe(Seen.tells(5 + lateNs, A, C, own));
      patient.observe(Seen.hears(7, A, candidacy)); // not new
      patient.observe(Seen.says(9, A, own));
      assertThat(patient.report().violations(ElectionSpec.BEHIND)).isEqualTo(lateNs);
    }
  }

  /** A knows the leader of term 2. It hears this at 5 ns, and this happens. */
  private static long behind(ElectionMessage heard, TraceEvent then) {
    Monitors patient = patient();
    patient.observe(Seen.stands(1, B, 2, id(B)));
    patient.observe(Seen.shows(2, A, leader(2, B)));
    patient.observe(Seen.hears(5, A, heard));
    patient.observe(then);
    patient.observe(Seen.tells(9, B, A, new ElectionMessage.Elected(id(B), 2, id(B))));
    return patient.report().violations(ElectionSpec.BEHIND);
  }

  @Test
  void aCandidacyThatIsNotBroadcastViolatesSays() {
    for (TraceEvent then :
        List.of(
            Seen.says(5, A, new ElectionMessage.Candidacy(id(A), 2, 1)),
            Seen.says(5, A, new ElectionMessage.Candidacy(id(A), 1, 1)),
            Seen.tells(5, A, B, new ElectionMessage.Candidacy(id(A), 2, 1)),
            Seen.says(6, A, new ElectionMessage.Candidacy(id(A), 2, 1)))) {
      Monitors patient = patient();
      patient.observe(Seen.stands(5, A, 2, id(A)));
      boolean isSaid = then.equals(Seen.says(5, A, new ElectionMessage.Candidacy(id(A), 2, 1)));
      assertThat(says(patient, then)).as(then.toString()).isEqualTo(isSaid ? 0 : 1);
    }
  }

  @Test
  void aLeaderThatDoesNotRepeatThatItLeadsViolatesSays() {
    long periodNs = NS_PER_MS;
    for (long pauseNs : List.of(periodNs, 3 * periodNs)) {
      Monitors patient = patient();
      for (RobotId robot : List.of(A, B, C)) {
        patient.observe(Seen.shows(2, robot, leader(1, A)));
      }
      for (long atNs = 2; atNs < 10 * periodNs; atNs += pauseNs) {
        patient.observe(Seen.says(atNs, A, new ElectionMessage.Elected(id(A), 1, id(A))));
      }
      long violations = patient.report().violations(ElectionSpec.SAYS);
      assertThat(violations > 0).as("%s ns", pauseNs).isEqualTo(pauseNs > 2 * periodNs);
    }
  }

  @Test
  void aLeaderThatDoesNotSaySoAtOnceViolatesSays() {
    for (long saysNs : List.of(2L, 3L)) {
      Monitors patient = patient();
      patient.observe(Seen.shows(2, B, leader(1, A))); // not of itself
      patient.observe(Seen.shows(2, A, leader(1, A)));
      patient.observe(Seen.says(saysNs, A, new ElectionMessage.Elected(id(A), 1, id(A))));
      patient.observe(Seen.shows(4, C, leader(1, A)));
      assertThat(patient.report().violations(ElectionSpec.SAYS)).isEqualTo(saysNs - 2);
    }
  }

  @Test
  void aDrawThatIsThatOfTheTermBeforeViolatesTurn() {
    for (long draw : List.of(6L, 7L)) {
      Monitors patient = patient();
      patient.observe(Seen.stands(1, A, 2, id(A)));
      patient.observe(Seen.says(1, A, new ElectionMessage.Candidacy(id(A), 2, 6)));
      patient.observe(Seen.stands(2, A, 2, id(A))); // again
      patient.observe(Seen.says(2, A, new ElectionMessage.Candidacy(id(A), 2, 6)));
      patient.observe(Seen.stands(3, A, 3, id(A)));
      patient.observe(Seen.says(3, A, new ElectionMessage.Candidacy(id(A), 3, draw)));
      assertThat(patient.report().violations(ElectionSpec.TURN)).isEqualTo(7 - draw);
    }
  }

  @Test
  void whoHasFailedAndProposesViolatesTold() {
    monitors.observe(Seen.exists(0, 3, id(A)));
    monitors.observe(Seen.calls(1, A, id(A)));
    monitors.observe(Seen.prepares(2, A, 1));
    monitors.observe(Seen.shows(301, A, Leader.FAIL));
    assertThat(monitors.report().violations(ElectionSpec.TOLD)).isZero();
    monitors.observe(Seen.prepares(302, A, 1));
    assertThat(monitors.report().violations(ElectionSpec.TOLD)).isEqualTo(1);
    monitors.observe(Seen.calls(303, A, id(A)));
    monitors.observe(Seen.prepares(304, A, 1));
    assertThat(monitors.report().violations(ElectionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void whoHearsOfALaterTermOrALaterProgramOfItsLeaderStands() {
    ProcessId again = ProcessId.first(B, 2);
    TraceEvent stands = Seen.says(5, A, new ElectionMessage.Candidacy(id(A), 2, 1));
    TraceEvent nothing = new Fault(5, C, Fault.CRASH, "");
    for (ElectionMessage heard :
        List.of(
            new ElectionMessage.Candidacy(id(C), 2, 1),
            new ElectionMessage.Candidacy(again, 1, 1))) {
      for (TraceEvent then : List.of(stands, nothing)) {
        Monitors patient = patient();
        patient.observe(Seen.shows(2, A, leader(1, B)));
        patient.observe(Seen.exists(3, 3, heard.from()));
        patient.observe(Seen.hears(5, A, heard));
        assertThat(says(patient, then)).isEqualTo(then.equals(stands) ? 0 : 1);
      }
    }
    Monitors patient = patient();
    patient.observe(Seen.shows(2, A, leader(1, B)));
    patient.observe(Seen.hears(5, A, new ElectionMessage.Candidacy(id(C), 1, 1)));
    assertThat(says(patient, nothing)).isZero();
  }

  @Test
  void whoDecidesATermBroadcastsItsLeader() {
    TraceEvent told = Seen.says(5, A, new ElectionMessage.Elected(id(A), 1, id(B)));
    TraceEvent nothing = new Fault(5, C, Fault.CRASH, "");
    for (TraceEvent then : List.of(told, nothing)) {
      Monitors patient = patient();
      patient.observe(Seen.hearsVote(5, A, B, 1));
      patient.observe(Seen.shows(5, A, leader(1, B)));
      assertThat(says(patient, then)).isEqualTo(then.equals(told) ? 0 : 1);
    }
  }

  /** What the lemma says after all that was said at one time. */
  private static long says(Monitors patient, TraceEvent then) {
    patient.observe(then);
    patient.observe(Seen.tells(9, B, A, new ElectionMessage.Elected(id(B), 2, id(B))));
    return patient.report().violations(ElectionSpec.SAYS);
  }

  /** With a message delay of 1 ms; A has the lowest id, and stands since 0. */
  @Test
  void aProposalBeforeTheStrategyPutsItFirstViolatesTurn() {
    long ms = 1_000_000;
    for (ElectionStrategy strategy : ElectionStrategy.values()) {
      assertThat(turns(strategy, 2 * ms)).as("listened").isZero();
      assertThat(turns(strategy, ms)).as("too early").isEqualTo(1);
    }
    ElectionMessage lower = new ElectionMessage.Candidacy(id(C), 1, 1);
    ElectionMessage higher = new ElectionMessage.Candidacy(id(C), 1, 3);
    assertThat(turns(ElectionStrategy.BULLY, 2 * ms, lower)).as("a higher id").isEqualTo(1);
    assertThat(turns(ElectionStrategy.BULLY, 10 * ms, lower)).as("silent since").isZero();
    assertThat(turns(ElectionStrategy.RANDOM_BALLOT, 2 * ms, lower)).isZero();
    assertThat(turns(ElectionStrategy.RANDOM_BALLOT, 3 * ms, higher)).isEqualTo(1);
    assertThat(turns(ElectionStrategy.RANDOM_BALLOT, 8 * ms, higher)).isZero();
  }

  @Test
  void aProposalOfAnotherCandidateThanTheFirstViolatesTurnUnlessAVoteBindsIt() {
    for (ProcessId leader : List.of(id(C), id(A))) {
      for (ProcessId voted : Arrays.asList(null, id(B))) {
        Monitors patient = patient(ElectionStrategy.RANDOM_BALLOT);
        patient.observe(Seen.hears(7_000_000, A, new ElectionMessage.Candidacy(id(C), 1, 3)));
        patient.observe(Seen.prepares(8_000_000, A, 1));
        patient.observe(Seen.hearsPromise(9_000_000, A, 1, voted));
        patient.observe(Seen.proposes(9_000_000, A, 1, leader));
        boolean isWrong = voted == null && leader.equals(id(A));
        assertThat(patient.report().violations(ElectionSpec.TURN)).isEqualTo(isWrong ? 1 : 0);
      }
    }
  }

  @Test
  void aProposalForAnEarlierTermThanItsOwnViolatesTurn() {
    for (long term : List.of(2L, 1L)) {
      Monitors patient = patient();
      patient.observe(Seen.stands(1, A, 2, id(A)));
      patient.observe(Seen.prepares(9_000_000, A, term));
      assertThat(patient.report().violations(ElectionSpec.TURN)).isEqualTo(2 - term);
    }
  }

  private static long turns(ElectionStrategy strategy, long atNs, ElectionMessage... heard) {
    Monitors patient = patient(strategy);
    for (ElectionMessage message : heard) {
      patient.observe(Seen.hears(1_500_000, A, message));
    }
    patient.observe(Seen.prepares(atNs, A, 1));
    assertThat(patient.report().checks(ElectionSpec.TURN)).isEqualTo(1);
    return patient.report().violations(ElectionSpec.TURN);
  }

  @Test
  void aLeaderThatIsBackAsAnotherIncarnationIsDeposedAtOnce() {
    Monitors patient = patient();
    patient.observe(Seen.shows(0, A, leader(1, B)));
    patient.observe(new Fault(1, B, Fault.CRASH, ""));
    patient.observe(new Fault(2, B, Fault.RESTART, ""));
    ProcessId again = ProcessId.first(B, 2);
    patient.observe(Seen.exists(3, 3, again));
    patient.observe(Seen.hears(4, A, new ElectionMessage.Candidacy(again, 1, 1)));
    patient.observe(Seen.stands(4, A, 2, id(A)));
    assertThat(patient.report().violations(ElectionSpec.SUSPECTED)).isZero();
  }

  @Test
  void aFailureBeforeTheDeadlineViolatesTold() {
    for (long failsNs : List.of(3_000_000L, 2_999_999L)) {
      Monitors patient = patient();
      patient.observe(Seen.shows(failsNs, A, Leader.FAIL));
      assertThat(patient.report().violations(ElectionSpec.TOLD)).isEqualTo(3_000_000 - failsNs);
    }
  }

  /** A silence of 2 ms, a deadline of 3 ms; all take part. */
  private static Monitors patient() {
    return patient(ElectionStrategy.BULLY);
  }

  private static Monitors patient(ElectionStrategy strategy) {
    ElectionSettings settings = new ElectionSettings(strategy, SynodTiming.DEFAULT, 1, 1, 2, 3);
    Monitors patient =
        new Monitors(List.of(new ElectionSpec(10_000_000, 10_000_000).patient(settings)));
    for (RobotId robot : List.of(A, B, C)) {
      patient.observe(Seen.exists(0, 3, id(robot)));
      patient.observe(Seen.calls(0, robot, id(robot)));
      patient.observe(Seen.stands(0, robot, 1, id(robot)));
      patient.observe(Seen.says(0, robot, new ElectionMessage.Candidacy(id(robot), 1, 2)));
    }
    return patient;
  }

  private void allTakePart() {
    for (RobotId robot : List.of(A, B, C)) {
      exists(robot);
      see(Seen.calls(nowNs, robot, id(robot)));
      stands(robot, 1);
    }
  }

  private void exists(RobotId robot) {
    see(Seen.exists(nowNs, 3, id(robot)));
  }

  private void stands(RobotId robot, long term) {
    see(Seen.stands(nowNs, robot, term, id(robot)));
  }

  private static ProcessId id(RobotId robot) {
    return ProcessId.first(robot, 1);
  }

  private static Leader leader(long term, RobotId robot) {
    return new Leader.Name(id(robot), term);
  }

  private void follows(RobotId robot, Leader leader, long atNs) {
    nowNs = atNs;
    see(Seen.shows(nowNs, robot, leader));
  }

  private void fault(RobotId robot, String name, long atNs) {
    nowNs = atNs;
    see(new Fault(nowNs, robot, name, ""));
  }

  private void see(TraceEvent event) {
    monitors.observe(event);
  }

  private void endAt(long endNs) {
    monitors.finish(endNs);
  }
}

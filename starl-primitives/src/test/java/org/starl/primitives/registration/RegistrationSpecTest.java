package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.membership.Short;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

class RegistrationSpecTest {

  private final Monitors monitors = new Monitors(List.of(new RegistrationSpec(1_000)));

  @Test
  void joinsAndARequestedLeaveHold() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    sees(10, "a", "1:a@1");
    sees(20, "b", "2:a@1,b@2");
    shows(20, "b", "2:[a, b]");
    acts(30, "a", "unregister", "a");
    sees(40, "b", "3:b@2");
    sees(41, "a", "3:b@2");
    assertThat(report(50).holds()).isTrue();
  }

  @Test
  void aFailureBeforeTheDeadlineViolatesRegistered() {
    long deadlineNs = 1_000_000;
    for (String call : List.of("do_register", "unregister")) {
      for (long lastsNs : List.of(deadlineNs, deadlineNs - 1)) {
        RegistrationSettings settings = RegistrationSettings.DEFAULT.withDeadlineMs(1);
        RegistrationSpec spec = new RegistrationSpec(9 * deadlineNs).patient(settings);
        Monitors patient = new Monitors(List.of(spec));
        patient.observe(Shown.acts(0, "a", "do_register", "a"));
        long beganNs = 0;
        if (call.equals("unregister")) {
          beganNs = 2;
          patient.observe(Shown.sees(1, "a", "1:a@1"));
          patient.observe(Shown.acts(beganNs, "a", call, "a"));
        }
        patient.observe(Shown.failed(beganNs + lastsNs, "a"));
        assertThat(patient.report().violations(RegistrationSpec.REGISTERED))
            .as("%s", call)
            .isEqualTo(deadlineNs - lastsNs);
      }
    }
  }

  @Test
  void whoDecidesAViewAndTellsNotAllViolatesInformed() {
    assertThat(uninformed("c", "v")).isZero();
    assertThat(uninformed("v")).as("c, which is removed").isEqualTo(1);
    assertThat(uninformed("c")).as("the acceptor v").isEqualTo(1);
  }

  /** The voter b decides the view 2, without c, and tells these robots. */
  private static long uninformed(String... told) {
    Monitors patient =
        new Monitors(List.of(new RegistrationSpec(1_000).patient(RegistrationSettings.DEFAULT)));
    patient.observe(Shown.acceptors(0, "b", "b", "v"));
    for (String name : List.of("b", "c")) {
      patient.observe(Shown.acts(0, name, "do_register", name));
      patient.observe(Shown.sees(1, name, "1:b@1,c@1")); // learned, not decided
    }
    patient.observe(Shown.acts(2, "c", "unregister", "c"));
    patient.observe(Shown.hearsVote(5, "b", "v", 2));
    for (String robot : told) {
      patient.observe(Shown.tells(5, "b", robot, 2));
    }
    patient.observe(Shown.sees(5, "b", "2:b@1"));
    patient.observe(Shown.tells(6, "b", "c", 2));
    patient.observe(Shown.tells(7, "b", "v", 2));
    return patient.report().violations(RegistrationSpec.INFORMED);
  }

  @Test
  void aListThatIsShownAfterARumourOfANewerOneViolatesRumour() {
    assertThat(rumoured(2, 5, "null")).isZero();
    assertThat(rumoured(2, 6, "null")).as("later").isEqualTo(1);
    assertThat(rumoured(2, 5, "1:[a]")).as("not at all").isEqualTo(1);
    assertThat(rumoured(1, 5, "1:[a]")).as("a view that it knows").isZero();
  }

  /** The robot a knows the view 1, hears of another one at 5 ns, and shows this. */
  private static long rumoured(long number, long atNs, String list) {
    Monitors patient =
        new Monitors(List.of(new RegistrationSpec(1_000).patient(RegistrationSettings.DEFAULT)));
    patient.observe(Shown.sees(0, "a", "0:"));
    patient.observe(Shown.acts(0, "a", "do_register", "a"));
    patient.observe(Shown.sees(1, "a", "1:a@1"));
    patient.observe(Shown.shows(1, "a", "1:[a]"));
    patient.observe(Shown.hearsProposal(5, "a", "b", number));
    patient.observe(Shown.shows(atNs, "a", list));
    long overNs = 5 + RegistrationSettings.DEFAULT.nullMs() * Time.NS_PER_MS;
    patient.observe(Shown.shows(overNs, "a", "1:[a]"));
    patient.observe(Shown.shows(overNs + 1, "a", "1:[a]"));
    return patient.report().violations(RegistrationSpec.RUMOUR);
  }

  /** The robot a is on the list of view 1, which it shows from 1 ns on. */
  static Monitors showsItsList(long boundNs) {
    RegistrationSpec spec =
        new RegistrationSpec(boundNs).patient(RegistrationSettings.DEFAULT).standingIn();
    Monitors patient = new Monitors(List.of(spec));
    patient.observe(Shown.acceptors(0, "a", "a", "v"));
    patient.observe(Shown.sees(0, "a", "0:"));
    patient.observe(Shown.shows(0, "a", "null"));
    patient.observe(Shown.acts(0, "a", "do_register", "a"));
    patient.observe(Shown.sees(1, "a", "1:a@1"));
    patient.observe(Shown.shows(1, "a", "1:[a]"));
    return patient;
  }

  private static final long NULL_NS = RegistrationSettings.DEFAULT.nullMs() * Time.NS_PER_MS;
  private static final long QUERY_NS = RegistrationSettings.DEFAULT.queryMs() * Time.NS_PER_MS;

  @Test
  void aListThatIsHiddenWithoutARumourViolatesRList() {
    Monitors patient = showsItsList(1_000);
    patient.observe(Shown.hearsProposal(5, "a", "b", 2));
    patient.observe(Shown.shows(5, "a", "null"));
    patient.observe(Shown.sees(6, "a", "2:a@1"));
    assertThat(patient.report().violations(RegistrationSpec.R_LIST)).isZero();
    patient.observe(Shown.sees(7, "a", "3:a@1"));
    assertThat(patient.report().violations(RegistrationSpec.R_LIST)).isEqualTo(1);
  }

  @Test
  void aListThatIsHiddenForTooLongViolatesShown() {
    for (long lastsNs : List.of(2 * NULL_NS, 2 * NULL_NS + 1)) {
      Monitors patient = showsItsList(1_000);
      patient.observe(Shown.hearsProposal(5, "a", "b", 2));
      patient.observe(Shown.shows(5, "a", "null"));
      patient.observe(Shown.shows(5 + lastsNs, "a", "1:[a]"));
      assertThat(patient.report().violations(RegistrationSpec.SHOWN))
          .isEqualTo(lastsNs - 2 * NULL_NS);
    }
  }

  @Test
  void whoDoesNotAskForTheViewThatItLacksViolatesAsks() {
    for (int lacking = 0; lacking <= 1; lacking++) {
      Monitors patient = showsItsList(1_000);
      patient.observe(Shown.hearsProposal(5, "a", "b", 2));
      patient.observe(Shown.shows(5, "a", "null"));
      SynodMessage question = new SynodMessage.Query(1);
      patient.observe(Shown.sends(NULL_NS, "a", "a", question));
      patient.observe(Shown.shows(NULL_NS, "a", "1:[a]"));
      patient.observe(Shown.sends(NULL_NS + lacking, "a", "v", question));
      patient.observe(Shown.shows(NULL_NS + 2, "a", "1:[a]"));
      assertThat(patient.report().violations(RegistrationSpec.ASKS)).isEqualTo(lacking);
    }
  }

  @Test
  void aRegisteredRobotThatAsksNoAcceptorViolatesAsks() {
    for (int late = 0; late <= 1; late++) {
      Monitors patient = showsItsList(1_000);
      patient.observe(Shown.sends(2 * QUERY_NS, "a", "v", new SynodMessage.Query(1)));
      patient.finish(4 * QUERY_NS + late);
      assertThat(patient.report().violations(RegistrationSpec.ASKS)).isEqualTo(late);
    }
  }

  @Test
  void whoDoesNotProposeTheViewThatItLacksViolatesCompletes() {
    for (long atNs : List.of(4 * NULL_NS, 4 * NULL_NS + 1)) {
      Monitors patient = showsItsList(1_000);
      patient.observe(Shown.hearsProposal(5, "a", "b", 2));
      patient.observe(Shown.shows(5, "a", "null"));
      patient.observe(Shown.shows(NULL_NS, "a", "1:[a]"));
      patient.observe(Shown.proposes(atNs, "a", 2));
      assertThat(patient.report().violations(RegistrationSpec.COMPLETES))
          .isEqualTo(atNs - 4 * NULL_NS);
    }
  }

  @Test
  void whoKeepsAnIdThatAMissedViewMayHaveHadViolatesFresh() {
    for (boolean isGivenUp : List.of(true, false)) {
      Monitors patient =
          new Monitors(List.of(new RegistrationSpec().patient(RegistrationSettings.DEFAULT)));
      patient.observe(Shown.sees(0, "a", "0:"));
      patient.observe(Shown.acts(0, "b", "do_register", "b"));
      patient.observe(Shown.acts(0, "a", "do_register", "a"));
      patient.observe(Shown.proposes(0, "a", 1));
      patient.observe(Shown.sees(1, "a", "1:b@1"));
      patient.observe(Shown.proposes(1, "a", 2));
      if (isGivenUp) {
        patient.observe(Shown.acts(2, "a", "give_up", "a"));
        patient.observe(Shown.acts(2, "a", "do_register", "a.2"));
        patient.observe(Shown.proposes(2, "a", 4));
      }
      patient.observe(Shown.sees(2, "a", "3:b@1"));
      assertThat(patient.report().violations(RegistrationSpec.FRESH)).isEqualTo(isGivenUp ? 0 : 1);
    }
  }

  @Test
  void aRobotThatConfinesItsPresentIdViolatesKeeps() {
    threeAreIn();
    confines(20, "a", "a", "", "");
    assertThat(monitors.report().violations(RegistrationSpec.KEEPS)).isEqualTo(1);
  }

  @Test
  void anIdOfAnEarlierStartThatStaysListedViolatesRegistered() {
    for (int late = 0; late <= 1; late++) {
      Monitors patient = showsItsList(1_000);
      patient.observe(new Fault(100, new RobotId("a"), "crash", ""));
      patient.observe(new Fault(200, new RobotId("a"), "restart", ""));
      patient.observe(Shown.sees(200, "a", "0:"));
      patient.finish(1_200 + late);
      assertThat(patient.report().violations(RegistrationSpec.REGISTERED)).isEqualTo(late);
    }
  }

  @Test
  void anIdThatIsLeftForAnotherOneMustGo() {
    acts(0, "a", "do_register", "a");
    sees(10, "a", "1:a@1");
    acts(20, "a", "unregister", "a");
    monitors.observe(Shown.failed(30, "a"));
    acts(5_000, "a", "do_register", "a.2");
    monitors.observe(Shown.failed(5_000, "a", false));
    sees(5_010, "a", "2:a@1,a.2@2");
    assertThat(monitors.report().holds()).isTrue();
    assertThat(report(6_011).violations(RegistrationSpec.REGISTERED)).isEqualTo(1);
  }

  @Test
  void equalNumbersWithUnequalListsViolateAgreement() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    sees(10, "a", "1:a@1");
    sees(10, "b", "1:b@1");
    assertThat(report(50).violations(RegistrationSpec.AGREEMENT)).isEqualTo(1);
  }

  @Test
  void aListThatDiffersFromItsViewViolatesRList() {
    acts(0, "a", "do_register", "a");
    sees(10, "a", "1:a@1");
    shows(10, "a", "1:[a, b]");
    assertThat(report(50).violations(RegistrationSpec.R_LIST)).isEqualTo(1);
  }

  @Test
  void theListOfARobotThatIsNotOnItViolatesRList() {
    shows(0, "b", "null");
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    sees(10, "b", "1:a@1");
    shows(10, "b", "1:[a]");
    assertThat(report(50).violations(RegistrationSpec.R_LIST)).isEqualTo(1);
  }

  @Test
  void anOlderListIsNotShownAfterANewerView() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    sees(10, "a", "1:a@1");
    shows(10, "a", "1:[a]");
    sees(20, "a", "2:a@1,b@2");
    shows(20, "a", "2:[a, b]");
    sees(30, "a", "3:a@1,b@2");
    shows(31, "a", "null");
    assertThat(report(50).violations())
        .extracting(SpecReport.Violation::toString)
        .containsExactly(
            "registration.rList violated at 0.000 s by a: registration/here: rList is 2:[a, b] after view");
  }

  @Test
  void aRobotOffTheFloorIsStillOnTheList() {
    acts(0, "a", "do_register", "a");
    sees(10, "a", "1:a@1");
    shows(10, "a", "1:[a]");
    monitors.observe(new Left(15, new RobotId("a")));
    sees(20, "a", "2:a@1");
    shows(20, "a", "2:[a]");
    assertThat(report(50).holds()).isTrue();
  }

  @Test
  void aMissingMemberViolatesKeepsInEitherOrderOfViews() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    sees(10, "b", "3:b@3");
    sees(20, "a", "1:a@1");
    assertThat(report(50).violations(RegistrationSpec.KEEPS)).isEqualTo(1);
  }

  @Test
  void anotherRobotCannotUnregisterAMember() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    sees(10, "a", "1:a@1");
    acts(15, "b", "unregister", "a");
    sees(20, "b", "2:b@2");
    assertThat(report(50).violations(RegistrationSpec.KEEPS)).isEqualTo(1);
  }

  @Test
  void anIdThatComesBackViolatesFresh() {
    acts(0, "a", "do_register", "a");
    sees(10, "a", "1:a@1");
    acts(20, "a", "unregister", "a");
    sees(30, "a", "2:");
    sees(40, "a", "3:a@3");
    assertThat(report(50).violations(RegistrationSpec.FRESH)).isPositive();
  }

  @Test
  void aLongRunStillChecksTheLatestViews() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    for (int number = 1; number <= 2_000; number++) {
      sees(number, "a", number + ":a@1");
    }
    sees(2_001, "b", "3:b@3"); // too old to be compared
    assertThat(monitors.report().violations(RegistrationSpec.AGREEMENT)).isZero();
    sees(2_002, "b", "1990:b@1990");
    assertThat(report(2_003).violations(RegistrationSpec.AGREEMENT)).isEqualTo(1);
  }

  @Test
  void anIdThatNeverAskedViolatesSoundness() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "a.2");
    sees(10, "a", "1:a@1,a.2@1");
    assertThat(report(50).violations(RegistrationSpec.SOUNDNESS)).isEqualTo(1);
  }

  @Test
  void aRobotNotRegisteredWithinTheBoundViolatesRegistered() {
    acts(0, "a", "do_register", "a");
    acts(500, "a", "do_register", "a.2");
    sees(900, "a", "1:a@1");
    assertThat(report(1_001).violations(RegistrationSpec.REGISTERED)).isEqualTo(1);
  }

  @Test
  void aRegisteredOrFailedRobotIsOwedNothing() {
    acts(0, "a", "do_register", "a");
    acts(0, "b", "do_register", "b");
    acts(0, "c", "do_register", "c");
    sees(900, "a", "1:a@1");
    monitors.observe(Shown.failed(950, "b"));
    sees(960, "c", "0:");
    assertThat(report(5_000).holds()).isTrue();
  }

  @Test
  void withoutAMajorityOfAcceptorsTheBoundIsSuspended() {
    monitors.observe(Shown.acceptors(0, "a", "x", "y"));
    acts(0, "a", "do_register", "a");
    fault(100, "x", "crash");
    fault(5_000, "x", "restart");
    assertThat(report(6_001).violations())
        .singleElement()
        .satisfies(late -> assertThat(late.timeNs()).isEqualTo(6_000));
  }

  @Test
  void aCrashedRobotIsOwedNothing() {
    acts(0, "a", "do_register", "a");
    fault(100, "a", "crash");
    assertThat(report(5_000).holds()).isTrue();
  }

  @Test
  void confinementByAFencerInBothListsKeepsAGhost() {
    threeAreIn();
    confines(20, "b", "a", "A B", "b");
    sees(30, "b", "2:b@1,c@1|a@1[A B]");
    confines(40, "c", "a", "B", "c");
    sees(50, "c", "3:b@1,c@1|a@1[B]");
    acts(60, "a", "give_up", "a");
    sees(70, "b", "4:b@1,c@1");
    assertThat(report(80).holds()).isTrue();
  }

  @Test
  void confinementWithoutFencerOrToFewerSectionsViolatesKeeps() {
    threeAreIn();
    sees(30, "b", "2:b@1,c@1|a@1[A B]");
    assertThat(monitors.report().violations(RegistrationSpec.KEEPS)).isEqualTo(1);
    confines(40, "c", "a", "B", "c");
    sees(50, "c", "3:b@1,c@1");
    assertThat(report(60).violations(RegistrationSpec.KEEPS)).isEqualTo(2);
  }

  @Test
  void aFencerThatLeavesInTheSameListViolatesKeeps() {
    threeAreIn();
    confines(20, "b", "a", "A", "b");
    acts(20, "b", "unregister", "b");
    sees(30, "c", "2:c@1|a@1[A]");
    assertThat(report(60).violations(RegistrationSpec.KEEPS)).isEqualTo(1);
  }

  @Test
  void aGhostThatGrowsOrReturnsIsAViolation() {
    threeAreIn();
    confines(20, "b", "a", "A", "b");
    sees(30, "c", "2:b@1,c@1|a@1[A]");
    sees(40, "c", "3:b@1,c@1|a@1[A B]");
    assertThat(monitors.report().violations(RegistrationSpec.KEEPS)).isEqualTo(1);
    sees(50, "c", "4:a@1,b@1,c@1");
    assertThat(report(60).violations(RegistrationSpec.FRESH)).isPositive();
  }

  @Test
  void aConfinementWithoutFencersByAnotherRobotDoesNotCount() {
    threeAreIn();
    confines(20, "b", "a", "", "");
    sees(30, "b", "2:b@1,c@1");
    assertThat(report(60).violations(RegistrationSpec.KEEPS)).isEqualTo(1);
  }

  @Test
  void instancesAreJudgedSeparately() {
    acts(0, "a", "do_register", "a");
    sees(10, "a", "1:a@1");
    monitors.observe(
        new Variable(
            20,
            new RobotId("b"),
            Instance.of(RegistrationFact.PRIMITIVE, "there"),
            RegistrationFact.VIEW,
            Short.view("1:")));
    assertThat(report(50).holds()).isTrue();
  }

  @Test
  void anIdThatIsGivenUpAndStaysListedViolatesRegistered() {
    threeAreIn();
    acts(20, "a", "give_up", "a");
    acts(20, "b", "unregister", "b");
    sees(30, "c", "2:a@1,c@1");
    assertThat(report(1_021).violations(RegistrationSpec.REGISTERED)).isEqualTo(1);
  }

  @Test
  void aFailedAttemptThatOthersCompleteMustBeUndone() {
    acts(0, "a", "do_register", "a");
    acts(10, "a", "give_up", "a");
    monitors.observe(Shown.failed(10, "a"));
    sees(20, "b", "1:a@1");
    assertThat(report(1_021).violations(RegistrationSpec.REGISTERED)).isEqualTo(1);
  }

  private void threeAreIn() {
    for (String name : List.of("a", "b", "c")) {
      acts(0, name, "do_register", name + "");
    }
    for (String name : List.of("a", "b", "c")) {
      sees(10, name, "1:a@1,b@1,c@1");
    }
  }

  private void confines(long atNs, String robot, String who, String sections, String fencers) {
    monitors.observe(Shown.confines(atNs, robot, who, sections, fencers));
  }

  private void fault(long atNs, String robot, String name) {
    monitors.observe(new Fault(atNs, new RobotId(robot), name, ""));
  }

  private void acts(long atNs, String robot, String verb, String id) {
    monitors.observe(Shown.acts(atNs, robot, verb, id));
  }

  private void sees(long atNs, String robot, String view) {
    monitors.observe(Shown.sees(atNs, robot, view));
  }

  private void shows(long atNs, String robot, String list) {
    monitors.observe(Shown.shows(atNs, robot, list));
  }

  private SpecReport report(long endNs) {
    monitors.finish(endNs);
    return monitors.report();
  }
}

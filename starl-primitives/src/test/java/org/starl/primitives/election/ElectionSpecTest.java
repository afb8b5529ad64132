package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

class ElectionSpecTest {

  private static final String SOURCE = "election/x";
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");

  private final Monitors monitors = new Monitors(List.of(new ElectionSpec(100, 300)));
  private long nowNs;

  @Test
  void anElectionWithOneLeaderForAllHolds() {
    allTakePart();
    follows(A, "1:b#1", 10);
    follows(B, "1:b#1", 20);
    follows(C, "1:b#1", 30);
    endAt(1_000);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
    assertThat(monitors.report().checks(ElectionSpec.ELECTED)).isEqualTo(3);
    assertThat(monitors.report().checks(ElectionSpec.TOLD)).isEqualTo(3);
  }

  @Test
  void twoLeadersInOneTermViolateAgreement() {
    allTakePart();
    follows(A, "1:b#1", 10);
    follows(B, "1:a#1", 20);
    assertThat(monitors.report().violations(ElectionSpec.AGREEMENT)).isEqualTo(1);
  }

  @Test
  void twoLeadersInTwoTermsHold() {
    allTakePart();
    stands(A, 2);
    follows(A, "1:b#1", 10);
    follows(B, "2:a#1", 20);
    assertThat(monitors.report().violations(ElectionSpec.AGREEMENT)).isZero();
  }

  @Test
  void aLeaderThatWasNoCandidateInItsTermViolatesSoundness() {
    allTakePart();
    follows(A, "2:b#1", 10);
    assertThat(monitors.report().violations(ElectionSpec.SOUNDNESS)).isEqualTo(1);
  }

  @Test
  void aCandidateThatNeverCalledDoElectionViolatesSoundness() {
    exists(A);
    stands(A, 1);
    follows(B, "1:a#1", 10);
    assertThat(monitors.report().violations(ElectionSpec.SOUNDNESS)).isEqualTo(1);
  }

  @Test
  void aCandidateWithoutLeaderWithinTheBoundViolatesElected() {
    allTakePart();
    follows(A, "1:b#1", 10);
    follows(B, "1:b#1", 10);
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
    see(new Variable(250, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isZero();
    endAt(251);
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isEqualTo(3);
  }

  @Test
  void aDeadLeaderMustBeReplaced() {
    allTakePart();
    for (RobotId robot : List.of(A, B, C)) {
      follows(robot, "1:c#1", 10);
    }
    fault(C, Fault.CRASH, 20);
    endAt(121);
    assertThat(monitors.report().violations(ElectionSpec.ELECTED)).isEqualTo(2);
  }

  @Test
  void failEndsTheWaitAndNullBeyondTheDeadlineViolatesTold() {
    allTakePart();
    fault(Fault.WORLD, Fault.BEGIN, 2);
    follows(A, "fail", 300);
    follows(B, "1:a#1", 300);
    endAt(302);
    assertThat(monitors.report().violations(ElectionSpec.TOLD)).isEqualTo(1);
    assertThat(monitors.report().checks(ElectionSpec.TOLD)).isEqualTo(3);
  }

  @Test
  void aTermThatGoesBackViolatesTerms() {
    allTakePart();
    stands(A, 2);
    follows(A, "1:b#1", 10);
    assertThat(monitors.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
    fault(A, Fault.CRASH, 20);
    fault(A, Fault.RESTART, 30);
    follows(A, "1:b#1", 40);
    assertThat(monitors.report().violations(ElectionSpec.TERMS)).isEqualTo(1);
  }

  @Test
  void aLiveLeaderThatIsDeposedInCalmViolatesElectedIfLeadersStay() {
    Monitors stay = new Monitors(List.of(new ElectionSpec(100, 300).leaderStays()));
    for (Monitors each : List.of(monitors, stay)) {
      each.observe(new Action(0, A, SOURCE, "Election", List.of("1", "a#1")));
      each.observe(new Action(0, A, SOURCE, "do_election", List.of("a#1")));
      each.observe(new Action(0, A, SOURCE, "candidate", List.of("1", "a#1")));
      each.observe(new Variable(1, A, SOURCE, "Leader", "1:a#1"));
      each.observe(new Action(2, A, SOURCE, "candidate", List.of("2", "a#1")));
    }
    assertThat(monitors.report().violations()).isEmpty();
    assertThat(stay.report().violations(ElectionSpec.ELECTED)).isEqualTo(1);
  }

  private void allTakePart() {
    for (RobotId robot : List.of(A, B, C)) {
      exists(robot);
      act(robot, "do_election", robot + "#1");
      stands(robot, 1);
    }
  }

  private void exists(RobotId robot) {
    act(robot, "Election", "3", robot + "#1");
  }

  private void stands(RobotId robot, long term) {
    act(robot, "candidate", String.valueOf(term), robot + "#1");
  }

  private void act(RobotId robot, String name, String... args) {
    see(new Action(nowNs, robot, SOURCE, name, List.of(args)));
  }

  private void follows(RobotId robot, String leader, long atNs) {
    nowNs = atNs;
    see(new Variable(nowNs, robot, SOURCE, "Leader", leader));
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

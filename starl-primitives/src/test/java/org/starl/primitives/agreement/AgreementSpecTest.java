package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

class AgreementSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");

  private final Monitors monitors = new Monitors(List.of(new AgreementSpec()));

  @Test
  void oneProposedValueEverywhereHolds() {
    proposes(A, "x", "01");
    decides(A, "x", "01");
    monitors.observe(Seen.knowsNone(2, B, "x"));
    decides(B, "x", "01");
    assertThat(monitors.report().holds()).isTrue();
    assertThat(monitors.report().checks(AgreementSpec.AGREEMENT)).isEqualTo(2);
  }

  @Test
  void twoValuesInOneInstanceViolateAgreement() {
    proposes(A, "x", "01");
    proposes(B, "x", "02");
    decides(A, "x", "01");
    decides(B, "x", "02");
    assertThat(monitors.report().violations(AgreementSpec.AGREEMENT)).isEqualTo(1);
  }

  @Test
  void instancesAreJudgedSeparately() {
    proposes(A, "x", "01");
    proposes(B, "y", "02");
    decides(A, "x", "01");
    decides(B, "y", "02");
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aValueThatWasNotProposedViolatesValidity() {
    proposes(A, "x", "01");
    decides(A, "x", "03");
    assertThat(monitors.report().violations(AgreementSpec.VALIDITY)).isEqualTo(1);
  }

  private static final long BOUND_NS = 100;

  private final Monitors bounded = new Monitors(List.of(new AgreementSpec(BOUND_NS)));

  private void sees(TraceEvent event) {
    bounded.observe(event);
  }

  private static Action serves(long timeNs, RobotId robot) {
    return Action.of(
        timeNs,
        robot,
        Seen.agreement("x"),
        AgreementFact.ACCEPTORS,
        new AgreementFact.Acceptors(List.of(A, B)));
  }

  private static Fault fault(long timeNs, RobotId robot, String name, String detail) {
    return new Fault(timeNs, robot, name, detail);
  }

  private long late() {
    return bounded.report().violations(AgreementSpec.DECIDED);
  }

  @Test
  void aProposalIsDecidedOrFailsWithinTheBound() {
    sees(serves(1, A));
    sees(Seen.proposes(1, A, "x", "01"));
    sees(Seen.proposes(1, B, "x", "02"));
    sees(Seen.decides(101, A, "x", "01"));
    sees(new Variable(101, B, Seen.agreement("x"), AgreementFact.FAILED, true));
    sees(Seen.proposes(150, A, "x", "01"));
    bounded.finish(1000);
    assertThat(late()).isZero();
    assertThat(bounded.report().checks(AgreementSpec.DECIDED)).isEqualTo(2);
  }

  @Test
  void aProposalWithoutAnswerViolatesDecided() {
    sees(serves(1, A));
    sees(Seen.proposes(1, A, "x", "01"));
    sees(Seen.decides(102, A, "x", "01"));
    assertThat(late()).isEqualTo(1);
  }

  @Test
  void nothingIsOwedWithoutAMajorityDuringFaultsOrToCrashedRobots() {
    sees(serves(1, A));
    sees(Seen.proposes(1, A, "x", "01"));
    sees(fault(50, B, Fault.CRASH, ""));
    sees(fault(300, B, Fault.RESTART, ""));
    sees(fault(350, Fault.WORLD, Fault.BEGIN, "loss(1)"));
    sees(fault(900, Fault.WORLD, Fault.END, "loss(1)"));
    sees(fault(950, A, Fault.CRASH, ""));
    sees(fault(960, A, Fault.RESTART, ""));
    sees(Seen.proposes(2000, A, "x", "01"));
    assertThat(late()).isZero();
    bounded.finish(2101);
    assertThat(late()).isEqualTo(1);
  }

  @Test
  void whoHasGivenUpAndAsksOnViolatesDecided() {
    sees(Seen.proposes(1, A, "x", "01"));
    asks(2);
    sees(new Variable(3, A, Seen.agreement("x"), AgreementFact.FAILED, true));
    assertThat(late()).isZero();
    asks(4);
    assertThat(late()).isEqualTo(1);
    sees(Seen.proposes(5, A, "x", "01"));
    asks(6);
    assertThat(late()).isEqualTo(1);
  }

  @Test
  void failedThatIsNotResetOrComesAfterTheDecisionViolatesFailed() {
    sees(Seen.proposes(1, A, "x", "01"));
    fails(2, true);
    sees(Seen.proposes(3, A, "x", "01"));
    fails(3, false);
    fails(4, true);
    sees(Seen.decides(5, A, "x", "01")); // it stays true
    asks(6);
    assertThat(bounded.report().violations(AgreementSpec.FAILED)).isZero();
    sees(Seen.proposes(7, A, "x", "01"));
    asks(8);
    assertThat(bounded.report().violations(AgreementSpec.FAILED)).as("not reset").isEqualTo(1);
    fails(9, false);
    fails(10, true);
    assertThat(bounded.report().violations(AgreementSpec.FAILED)).as("it knows").isEqualTo(2);
  }

  private void fails(long timeNs, boolean isFailed) {
    sees(new Variable(timeNs, A, Seen.agreement("x"), AgreementFact.FAILED, isFailed));
  }

  @Test
  void whoDecidesAndTellsNotAllAcceptorsViolatesInformed() {
    assertThat(uninformed(1)).isZero();
    assertThat(uninformed(2)).as("a step later").isEqualTo(1);
  }

  /** The acceptor A hears the last vote and decides at 1 ns, and tells B at this time. */
  private static long uninformed(long atNs) {
    Monitors monitors = new Monitors(List.of(new AgreementSpec(BOUND_NS)));
    Ballot ballot = new Ballot(1, new ProcessId(A, 1));
    Instance x = Seen.agreement("x");
    SynodMessage vote = new SynodMessage.Accepted(1, ballot);
    SynodMessage decided = new SynodMessage.Decided(1, Value.EMPTY);
    monitors.observe(serves(0, A));
    monitors.observe(Seen.decides(0, B, "y", "01")); // of another agreement
    monitors.observe(new Delivered(1, A, B, x, 1, SynodMessage.SHAPE, vote));
    monitors.observe(Seen.decides(1, A, "x", "01"));
    monitors.observe(new Sent(atNs, A, "b", x, 2, 1, SynodMessage.SHAPE, decided));
    monitors.observe(fault(3, B, Fault.CRASH, ""));
    return monitors.report().violations(AgreementSpec.INFORMED);
  }

  private void asks(long timeNs) {
    Ballot ballot = new Ballot(1, new ProcessId(A, 1));
    SynodMessage prepare = new SynodMessage.Prepare(1, ballot, Value.EMPTY);
    sees(new Sent(timeNs, A, "b", Seen.agreement("x"), 1, 1, SynodMessage.SHAPE, prepare));
  }

  private void proposes(RobotId robot, String xid, String value) {
    monitors.observe(Seen.proposes(1, robot, xid, value));
  }

  private void decides(RobotId robot, String xid, String value) {
    monitors.observe(Seen.decides(2, robot, xid, value));
  }
}

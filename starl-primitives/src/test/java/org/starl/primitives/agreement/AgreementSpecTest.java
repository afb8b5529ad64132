package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

class AgreementSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");

  private final Monitors monitors = new Monitors(List.of(new AgreementSpec()));

  @Test
  void oneProposedValueEverywhereHolds() {
    proposes(A, "agreement/x", "01");
    decides(A, "agreement/x", "01");
    decides(B, "agreement/x", "null");
    decides(B, "agreement/x", "01");
    assertThat(monitors.report().holds()).isTrue();
    assertThat(monitors.report().checks(AgreementSpec.AGREEMENT)).isEqualTo(2);
  }

  @Test
  void twoValuesInOneInstanceViolateAgreement() {
    proposes(A, "agreement/x", "01");
    proposes(B, "agreement/x", "02");
    decides(A, "agreement/x", "01");
    decides(B, "agreement/x", "02");
    assertThat(monitors.report().violations(AgreementSpec.AGREEMENT)).isEqualTo(1);
  }

  @Test
  void instancesAreJudgedSeparately() {
    proposes(A, "agreement/x", "01");
    proposes(B, "agreement/y", "02");
    decides(A, "agreement/x", "01");
    decides(B, "agreement/y", "02");
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aValueThatWasNotProposedViolatesValidity() {
    proposes(A, "agreement/x", "01");
    decides(A, "agreement/x", "03");
    assertThat(monitors.report().violations(AgreementSpec.VALIDITY)).isEqualTo(1);
  }

  private static final long BOUND_NS = 100;

  private final Monitors bounded = new Monitors(List.of(new AgreementSpec(BOUND_NS)));

  private void sees(TraceEvent event) {
    bounded.observe(event);
  }

  private static Action act(long timeNs, RobotId robot, String name, String... args) {
    return new Action(timeNs, robot, "agreement/x", name, List.of(args));
  }

  private static Variable shows(long timeNs, RobotId robot, String name, String value) {
    return new Variable(timeNs, robot, "agreement/x", name, value);
  }

  private static Fault fault(long timeNs, RobotId robot, String name, String detail) {
    return new Fault(timeNs, robot, name, detail);
  }

  private long late() {
    return bounded.report().violations(AgreementSpec.DECIDED);
  }

  @Test
  void aProposalIsDecidedOrFailsWithinTheBound() {
    sees(act(1, A, "acceptors", "a", "b"));
    sees(act(1, A, "propose", "01"));
    sees(act(1, B, "propose", "02"));
    sees(shows(101, A, "decided", "01"));
    sees(shows(101, B, "failed", "true"));
    sees(act(150, A, "propose", "01"));
    bounded.finish(1000);
    assertThat(late()).isZero();
    assertThat(bounded.report().checks(AgreementSpec.DECIDED)).isEqualTo(2);
  }

  @Test
  void aProposalWithoutAnswerViolatesDecided() {
    sees(act(1, A, "acceptors", "a", "b"));
    sees(act(1, A, "propose", "01"));
    sees(shows(102, A, "decided", "01"));
    assertThat(late()).isEqualTo(1);
  }

  @Test
  void nothingIsOwedWithoutAMajorityDuringFaultsOrToCrashedRobots() {
    sees(act(1, A, "acceptors", "a", "b"));
    sees(act(1, A, "propose", "01"));
    sees(fault(50, B, Fault.CRASH, ""));
    sees(fault(300, B, Fault.RESTART, ""));
    sees(fault(350, Fault.WORLD, Fault.BEGIN, "loss(1)"));
    sees(fault(900, Fault.WORLD, Fault.END, "loss(1)"));
    sees(fault(950, A, Fault.CRASH, ""));
    sees(fault(960, A, Fault.RESTART, ""));
    sees(act(2000, A, "propose", "01"));
    assertThat(late()).isZero();
    bounded.finish(2101);
    assertThat(late()).isEqualTo(1);
  }

  private void proposes(RobotId robot, String source, String value) {
    monitors.observe(new Action(1, robot, source, "propose", List.of(value)));
  }

  private void decides(RobotId robot, String source, String value) {
    monitors.observe(new Variable(2, robot, source, "decided", value));
  }
}

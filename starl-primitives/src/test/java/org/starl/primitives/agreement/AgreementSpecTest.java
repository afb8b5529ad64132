package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent.Action;
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
  void anotherInstanceIsAnotherMatter() {
    proposes(A, "agreement/x", "01");
    proposes(B, "agreement/y", "02");
    decides(A, "agreement/x", "01");
    decides(B, "agreement/y", "02");
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void aValueThatNobodyProposedViolatesValidity() {
    proposes(A, "agreement/x", "01");
    decides(A, "agreement/x", "03");
    assertThat(monitors.report().violations(AgreementSpec.VALIDITY)).isEqualTo(1);
  }

  private void proposes(RobotId robot, String source, String value) {
    monitors.observe(new Action(1, robot, source, "propose", List.of(value)));
  }

  private void decides(RobotId robot, String source, String value) {
    monitors.observe(new Variable(2, robot, source, "decided", value));
  }
}

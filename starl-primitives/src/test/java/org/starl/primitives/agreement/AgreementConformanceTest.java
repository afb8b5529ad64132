package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementAutomaton.States;
import org.starl.primitives.conformance.ShownRun;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class AgreementConformanceTest {

  private final ShownRun<States, AgreementAction> run = new ShownRun<>(AgreementConformance::new);

  private void proposes(String robot, String value) {
    run.has(Seen.proposes(0, new RobotId(robot), "x", value));
  }

  private void knows(String robot, String value) {
    run.has(Seen.decides(0, new RobotId(robot), "x", value));
  }

  private void knowsNone(String robot) {
    run.has(Seen.knowsNone(0, new RobotId(robot), "x"));
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    knowsNone("a");
    proposes("a", "01");
    proposes("b", "02");
    knows("b", "01");
    knows("a", "01");
    knowsNone("b");
    knows("b", "01");
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "propose(a, 01)",
            "propose(b, 02)",
            "choose(01)",
            "decide(b)",
            "decided(b) = up(01)",
            "decide(a)",
            "decided(a) = up(01)",
            "restart(b)",
            "decided(b) = bottom",
            "decide(b)",
            "decided(b) = up(01)");
  }

  @Test
  void aSecondDecidedValueDeviates() {
    proposes("a", "01");
    proposes("a", "02");
    knows("a", "01");
    knows("b", "02");
    assertThat(run.details())
        .containsExactly("agreement/x: decided(b) is up(01), but the trace has up(02)");
  }

  @Test
  void aDecisionThatWasNotProposedDeviates() {
    knows("b", "03");
    assertThat(run.details())
        .containsExactly(
            "agreement/x: choose(03) is not enabled: v in proposed is false: proposed = []");
  }
}

package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.RobotId;
import org.starl.primitives.agreement.AgreementAutomaton.States;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class AgreementConformanceTest {

  private final List<String> steps = new ArrayList<>();
  private final Monitors monitors =
      new Monitors(
          List.of(
              new AgreementConformance(
                  new Steps<States, AgreementAction>() {
                    @Override
                    public void stepped(
                        String instance, TraceEvent event, AgreementAction action, States after) {
                      steps.add(action.text());
                    }

                    @Override
                    public void resulted(
                        String instance, String function, Object argument, Object value) {
                      steps.add(function + "(" + argument + ") = " + value);
                    }
                  })));

  private void proposes(String robot, String value) {
    monitors.observe(new Action(0, new RobotId(robot), "agreement/x", "propose", List.of(value)));
  }

  private void knows(String robot, String value) {
    monitors.observe(new Variable(0, new RobotId(robot), "agreement/x", "decided", value));
  }

  private List<String> details() {
    return monitors.report().violations().stream().map(SpecReport.Violation::detail).toList();
  }

  @Test
  void eachEventIsTheActionOfTheTable() {
    knows("a", "null");
    proposes("a", "01");
    proposes("b", "02");
    knows("b", "01");
    knows("a", "01");
    knows("b", "null");
    knows("b", "01");
    assertThat(details()).isEmpty();
    assertThat(steps)
        .containsExactly(
            "propose(a, 01)",
            "propose(b, 02)",
            "choose(01)",
            "decide(b)",
            "decided(b) = up(01)",
            "decide(a)",
            "decided(a) = up(01)",
            "restart(b)",
            "decide(b)",
            "decided(b) = up(01)");
  }

  @Test
  void anotherValueThanTheChosenOneDeviates() {
    proposes("a", "01");
    proposes("a", "02");
    knows("a", "01");
    knows("b", "02");
    assertThat(details())
        .containsExactly("agreement/x: decided(b) is up(01), but the trace has up(02)");
  }

  @Test
  void whatNobodyProposedDeviates() {
    knows("b", "03");
    assertThat(details())
        .containsExactly(
            "agreement/x: choose(03) is not enabled: proposed(v) is false: nobody proposed 03");
  }
}

package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.primitives.conformance.ShownRun;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class BarrierConformanceTest {

  private static final String SOURCE = "barrier/x";

  private final ShownRun<States, BarrierAction> run = new ShownRun<>(BarrierConformance::new);

  private void acts(String robot, String name, String... args) {
    run.has(new Action(0, new RobotId(robot), SOURCE, name, List.of(args)));
  }

  private void arrives(String robot, int generation) {
    acts(robot, "arrive", "" + generation, robot + "#1");
  }

  private void shows(String robot, String outcome) {
    run.has(new Variable(0, new RobotId(robot), SOURCE, "outcome", outcome));
  }

  private void made() {
    for (String robot : List.of("a", "b", "c")) {
      acts(robot, "Barrier", robot + "#1", "a#1", "b#1", "c#1");
    }
    run.forgetSteps();
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    made();
    arrives("a", 1);
    arrives("b", 1);
    arrives("c", 1);
    shows("b", "1:passed");
    shows("a", "1:passed");
    shows("a", "null");
    arrives("a", 2);
    shows("a", "2:failed[b#1, c#1]");
    shows("b", "2:excluded");
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "arrive(a#1, 1)",
            "arrive(b#1, 1)",
            "arrive(c#1, 1)",
            "decide(1, passed)",
            "tell(b#1, 1)",
            "told(b#1) = 1:passed",
            "tell(a#1, 1)",
            "told(a#1) = 1:passed",
            "arrive(a#1, 2)",
            "decide(2, failed([b#1, c#1]))",
            "tell(a#1, 2)",
            "told(a#1) = 2:failed[b#1, c#1]",
            "tell(b#1, 2)",
            "told(b#1) = 2:excluded");
  }

  @Test
  void anEarlyExcludedWaitsForTheOutcome() {
    made();
    shows("b", "1:excluded");
    assertThat(run.steps()).isEmpty();
    shows("a", "1:failed[b#1]");
    assertThat(run.steps())
        .containsExactly(
            "decide(1, failed([b#1]))",
            "tell(b#1, 1)",
            "told(b#1) = 1:excluded",
            "tell(a#1, 1)",
            "told(a#1) = 1:failed[b#1]");
    assertThat(run.details()).isEmpty();
  }

  @Test
  void atTheEndTheToldExcludedAreAllTheMissing() {
    made();
    shows("b", "1:excluded");
    shows("c", "1:excluded");
    run.ends(1);
    assertThat(run.steps())
        .containsExactly(
            "decide(1, failed([b#1, c#1]))",
            "tell(b#1, 1)",
            "told(b#1) = 1:excluded",
            "tell(c#1, 1)",
            "told(c#1) = 1:excluded");
    assertThat(run.details()).isEmpty();
  }

  @Test
  void otherEventsMapToNoAction() {
    shows("a", "null");
    arrives("a", 1);
    shows("a", "1:passed");
    made();
    acts("a", "Barrier", "a#2", "a#1", "b#1", "c#1");
    run.forgetSteps();
    shows("a", "null");
    shows("a", "0:excluded");
    shows("b", "1:unknown");
    acts("b", "arrive", "1", "c#1");
    run.has(new Action(0, new RobotId("b"), "app", "arrive", List.of("1", "b#1")));
    run.ends(1);
    assertThat(run.steps()).isEmpty();
    assertThat(run.details()).isEmpty();
  }

  @Test
  void passingBeforeAllHaveArrivedDeviates() {
    made();
    arrives("a", 1);
    shows("a", "1:passed");
    assertThat(run.details())
        .containsExactly(
            "barrier/x: decide(1, passed) is not enabled: right?(g, o) is false:"
                + " members(1) = [a#1, b#1, c#1], arrived(1) = [a#1]");
  }

  @Test
  void aSecondOutcomeDeviates() {
    made();
    shows("a", "1:failed[c#1]");
    shows("b", "1:failed[a#1, c#1]");
    assertThat(run.details())
        .containsExactly(
            "barrier/x: told(b#1) is 1:failed[c#1], but the trace has 1:failed[a#1, c#1]");
  }

  @Test
  void aRobotToldExcludedThatIsNotMissingDeviates() {
    made();
    shows("b", "1:excluded");
    shows("a", "1:failed[c#1]");
    assertThat(run.details())
        .containsExactly("barrier/x: told(b#1) is 1:failed[c#1], but the trace has 1:excluded");
  }

  @Test
  void aGenerationDecidedBeforeItsPredecessorDeviates() {
    made();
    shows("a", "2:failed[c#1]");
    assertThat(run.details())
        .containsExactly(
            "barrier/x: decide(2, failed([c#1])) is not enabled:"
                + " right?(g, o) is false: outcome(1) = open");
  }

  @Test
  void aDifferentMemberListDeviates() {
    made();
    acts("d", "Barrier", "d#1", "a#1", "d#1");
    assertThat(run.details())
        .containsExactly("barrier/x: first(d#1) is [a#1, b#1, c#1], but the trace has [a#1, d#1]");
  }

  @Test
  void aRobotWithoutAnnouncedIdIsToldTheSameOutcome() {
    made();
    shows("a", "1:failed[c#1]");
    shows("d", "1:failed[c#1]");
    assertThat(run.details()).isEmpty();
    shows("d", "1:passed");
    assertThat(run.details())
        .containsExactly("barrier/x: outcome(1) is failed([c#1]), but the trace has passed");
  }
}

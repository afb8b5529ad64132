package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.barrier.Seen.SOURCE;
import static org.starl.primitives.barrier.Seen.excluded;
import static org.starl.primitives.barrier.Seen.failed;
import static org.starl.primitives.barrier.Seen.passed;
import static org.starl.primitives.barrier.Seen.unknown;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.primitives.conformance.ShownRun;
import org.starl.trace.Instance;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class BarrierConformanceTest {

  private final ShownRun<States, BarrierAction> run = new ShownRun<>(BarrierConformance::new);

  private void exists(String id, String... members) {
    run.has(Seen.exists(0, SOURCE, id, members));
  }

  private void arrives(String robot, long generation) {
    run.has(Seen.arrives(0, new RobotId(robot), SOURCE, generation, robot + ""));
  }

  private void shows(String robot, BarrierOutcome outcome) {
    run.has(Seen.shows(0, new RobotId(robot), outcome));
  }

  private void made() {
    for (String robot : List.of("a", "b", "c")) {
      exists(robot + "", "a", "b", "c");
    }
    run.forgetSteps();
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    made();
    arrives("a", 1);
    arrives("b", 1);
    arrives("c", 1);
    shows("b", passed(1));
    shows("a", passed(1));
    shows("a", BarrierOutcome.NONE_YET);
    arrives("a", 2);
    shows("a", failed(2, "b", "c"));
    shows("b", excluded(2));
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "arrive(a, 1)",
            "arrive(b, 1)",
            "arrive(c, 1)",
            "decide(1, passed)",
            "tell(b, 1)",
            "told(b) = 1:passed",
            "tell(a, 1)",
            "told(a) = 1:passed",
            "arrive(a, 2)",
            "decide(2, failed([b, c]))",
            "tell(a, 2)",
            "told(a) = 2:failed[b, c]",
            "tell(b, 2)",
            "told(b) = 2:excluded");
  }

  @Test
  void anEarlyExcludedWaitsForTheOutcome() {
    made();
    shows("b", excluded(1));
    assertThat(run.steps()).isEmpty();
    shows("a", failed(1, "b"));
    assertThat(run.steps())
        .containsExactly(
            "decide(1, failed([b]))",
            "tell(b, 1)",
            "told(b) = 1:excluded",
            "tell(a, 1)",
            "told(a) = 1:failed[b]");
    assertThat(run.details()).isEmpty();
  }

  @Test
  void atTheEndTheToldExcludedAreAllTheMissing() {
    made();
    shows("b", excluded(1));
    shows("c", excluded(1));
    run.ends(1);
    assertThat(run.steps())
        .containsExactly(
            "decide(1, failed([b, c]))",
            "tell(b, 1)",
            "told(b) = 1:excluded",
            "tell(c, 1)",
            "told(c) = 1:excluded");
    assertThat(run.details()).isEmpty();
  }

  @Test
  void otherEventsMapToNoAction() {
    shows("a", BarrierOutcome.NONE_YET);
    arrives("a", 1);
    shows("a", passed(1));
    made();
    exists("a.2", "a", "b", "c");
    run.forgetSteps();
    shows("a", BarrierOutcome.NONE_YET);
    shows("a", excluded(0));
    shows("b", unknown(1));
    run.has(Seen.arrives(0, new RobotId("b"), SOURCE, 1, "c"));
    run.has(Seen.arrives(0, new RobotId("b"), Instance.APP, 1, "b"));
    run.ends(1);
    assertThat(run.steps()).isEmpty();
    assertThat(run.details()).isEmpty();
  }

  @Test
  void passingBeforeAllHaveArrivedDeviates() {
    made();
    arrives("a", 1);
    shows("a", passed(1));
    assertThat(run.details())
        .containsExactly(
            "barrier/x: decide(1, passed) is not enabled: right?(g, o) is false:"
                + " members(1) = [a, b, c], arrived(1) = [a]");
  }

  @Test
  void aSecondOutcomeDeviates() {
    made();
    shows("a", failed(1, "c"));
    shows("b", failed(1, "a", "c"));
    assertThat(run.details())
        .containsExactly("barrier/x: told(b) is 1:failed[c], but the trace has 1:failed[a, c]");
  }

  @Test
  void aRobotToldExcludedThatIsNotMissingDeviates() {
    made();
    shows("b", excluded(1));
    shows("a", failed(1, "c"));
    assertThat(run.details())
        .containsExactly("barrier/x: told(b) is 1:failed[c], but the trace has 1:excluded");
  }

  @Test
  void aGenerationDecidedBeforeItsPredecessorDeviates() {
    made();
    shows("a", failed(2, "c"));
    assertThat(run.details())
        .containsExactly(
            "barrier/x: decide(2, failed([c])) is not enabled:"
                + " right?(g, o) is false: outcome(1) = open");
  }

  @Test
  void aDifferentMemberListDeviates() {
    made();
    exists("d", "a", "d");
    assertThat(run.details())
        .containsExactly("barrier/x: first(d) is [a, b, c], but the trace has [a, d]");
  }

  @Test
  void aRobotWithoutAnnouncedIdIsToldTheSameOutcome() {
    made();
    shows("a", failed(1, "c"));
    shows("d", failed(1, "c"));
    assertThat(run.details()).isEmpty();
    shows("d", passed(1));
    assertThat(run.details())
        .containsExactly("barrier/x: outcome(1) is failed([c]), but the trace has passed");
  }
}

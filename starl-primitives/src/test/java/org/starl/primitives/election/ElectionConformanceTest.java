package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.election.ElectionAutomaton.States;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class ElectionConformanceTest {

  private static final String SOURCE = "election/x";

  private final ShownRun<States, ElectionAction> run = new ShownRun<>(ElectionConformance::new);

  private void acts(String robot, String name, String... args) {
    run.has(new Action(0, new RobotId(robot), SOURCE, name, List.of(args)));
  }

  private void shows(String robot, String leader) {
    run.has(new Variable(0, new RobotId(robot), SOURCE, "Leader", leader));
  }

  private void stands(String robot, String term) {
    acts(robot, "Election", "2", robot + "#1");
    acts(robot, "do_election", robot + "#1");
    acts(robot, "candidate", term, robot + "#1");
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    shows("a", "null");
    acts("a", "Election", "2", "a#1");
    acts("b", "Election", "2", "b#1");
    acts("a", "do_election", "a#1");
    acts("a", "candidate", "1", "a#1");
    shows("a", "1:a#1");
    shows("b", "1:a#1");
    shows("b", "fail");
    shows("a", "null");
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "do_election(a#1)",
            "candidate(a#1, 1)",
            "elect(1, a#1)",
            "learn(a#1, 1)",
            "Leader(a#1) = Known[term=1, who=up(a#1)]",
            "learn(b#1, 1)",
            "Leader(b#1) = Known[term=1, who=up(a#1)]",
            "fail(b#1)",
            "Leader(b#1) = Known[term=1, who=bottom]",
            "fail(a#1)",
            "Leader(a#1) = Known[term=1, who=bottom]");
  }

  @Test
  void aRestartedRobotHasAnotherId() {
    stands("a", "1");
    shows("a", "1:a#1");
    run.forgetSteps();
    shows("a", "null");
    acts("a", "Election", "2", "a#2");
    shows("a", "1:a#1");
    assertThat(run.steps())
        .containsExactly(
            "fail(a#1)",
            "Leader(a#1) = Known[term=1, who=bottom]",
            "learn(a#2, 1)",
            "Leader(a#2) = Known[term=1, who=up(a#1)]");
    acts("a", "candidate", "2", "a#2");
    assertThat(run.details())
        .containsExactly(
            "election/x: candidate(a#2, 2) is not enabled: i in part is false: part = [a#1]");
  }

  @Test
  void otherEventsMapToNoAction() {
    acts("a", "Election", "2", "a#1");
    acts("b", "do_election", "a#1");
    acts("b", "candidate", "1", "a#1");
    shows("a", "null");
    run.has(new Variable(0, new RobotId("a"), SOURCE, "failed", "true"));
    run.has(new Action(0, new RobotId("a"), "app", "do_election", List.of("a#1")));
    assertThat(run.steps()).isEmpty();
    assertThat(run.details()).isEmpty();
  }

  @Test
  void aSecondLeaderOfATermDeviates() {
    stands("a", "1");
    stands("b", "1");
    shows("a", "1:a#1");
    shows("b", "1:b#1");
    assertThat(run.details())
        .containsExactly(
            "election/x: Leader(b#1) is Known[term=1, who=up(a#1)],"
                + " but the trace has Known[term=1, who=up(b#1)]");
  }

  @Test
  void aRobotWithoutAnnouncedIdMustShowTheElectedLeader() {
    stands("a", "1");
    shows("c", "1:a#1");
    assertThat(run.details()).isEmpty();
    shows("d", "1:b#1");
    assertThat(run.details())
        .containsExactly("election/x: elected(1) is up(a#1), but the trace has up(b#1)");
  }

  @Test
  void aLeaderThatWasNoCandidateDeviates() {
    stands("a", "1");
    shows("a", "2:a#1");
    assertThat(run.details())
        .containsExactly(
            "election/x: elect(2, a#1) is not enabled: i in stood(n) is false: stood(2) = []");
  }
}

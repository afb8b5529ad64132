package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.election.ElectionAutomaton.States;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class ElectionConformanceTest {

  private static final ProcessId A1 = ProcessId.first(new RobotId("a"), 1);
  private static final ProcessId A2 = ProcessId.first(new RobotId("a"), 2);
  private static final ProcessId B1 = ProcessId.first(new RobotId("b"), 1);

  private final ShownRun<States, ElectionAction> run = new ShownRun<>(ElectionConformance::new);

  private void exists(ProcessId i) {
    run.has(Seen.exists(0, 2, i));
  }

  private void calls(ProcessId i) {
    run.has(Seen.calls(0, i.robot(), i));
  }

  private void stands(ProcessId i, long term) {
    run.has(Seen.stands(0, i.robot(), term, i));
  }

  private void shows(String robot, Leader leader) {
    run.has(Seen.shows(0, new RobotId(robot), leader));
  }

  private void shows(String robot, long term, ProcessId leader) {
    shows(robot, new Leader.Name(leader, term));
  }

  private void standsAtOnce(ProcessId i, long term) {
    exists(i);
    calls(i);
    stands(i, term);
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    shows("a", Leader.NONE);
    exists(A1);
    exists(B1);
    calls(A1);
    stands(A1, 1);
    shows("a", 1, A1);
    shows("b", 1, A1);
    shows("b", Leader.FAIL);
    shows("a", Leader.NONE);
    assertThat(run.details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "do_election(a)",
            "candidate(a, 1)",
            "elect(1, a)",
            "learn(a, 1)",
            "Leader(a) = Known[term=1, who=up(a)]",
            "learn(b, 1)",
            "Leader(b) = Known[term=1, who=up(a)]",
            "fail(b)",
            "Leader(b) = Known[term=1, who=bottom]",
            "fail(a)",
            "Leader(a) = Known[term=1, who=bottom]");
  }

  @Test
  void aRestartedRobotHasAnotherId() {
    standsAtOnce(A1, 1);
    shows("a", 1, A1);
    run.forgetSteps();
    shows("a", Leader.NONE);
    exists(A2);
    shows("a", 1, A1);
    assertThat(run.steps())
        .containsExactly(
            "fail(a)",
            "Leader(a) = Known[term=1, who=bottom]",
            "learn(a.2, 1)",
            "Leader(a.2) = Known[term=1, who=up(a)]");
    stands(A2, 2);
    assertThat(run.details())
        .containsExactly(
            "election/x: candidate(a.2, 2) is not enabled: i in part is false: part = [a]");
  }

  @Test
  void otherEventsMapToNoAction() {
    exists(A1);
    run.has(Seen.calls(0, B1.robot(), A1));
    run.has(Seen.stands(0, B1.robot(), 1, A1));
    shows("a", Leader.NONE);
    run.has(new Variable(0, A1.robot(), Seen.SOURCE, ElectionFact.FAILED, true));
    run.has(
        Action.of(
            0,
            A1.robot(),
            Instance.APP,
            ElectionFact.DO_ELECTION,
            new ElectionAction.do_election(A1)));
    assertThat(run.steps()).isEmpty();
    assertThat(run.details()).isEmpty();
  }

  @Test
  void aSecondLeaderOfATermDeviates() {
    standsAtOnce(A1, 1);
    standsAtOnce(B1, 1);
    shows("a", 1, A1);
    shows("b", 1, B1);
    assertThat(run.details())
        .containsExactly(
            "election/x: Leader(b) is Known[term=1, who=up(a)],"
                + " but the trace has Known[term=1, who=up(b)]");
  }

  @Test
  void aRobotWithoutAnnouncedIdMustShowTheElectedLeader() {
    standsAtOnce(A1, 1);
    shows("c", 1, A1);
    assertThat(run.details()).isEmpty();
    shows("d", 1, B1);
    assertThat(run.details())
        .containsExactly("election/x: elected(1) is up(a), but the trace has up(b)");
  }

  @Test
  void aLeaderThatWasNoCandidateDeviates() {
    standsAtOnce(A1, 1);
    shows("a", 2, A1);
    assertThat(run.details())
        .containsExactly(
            "election/x: elect(2, a) is not enabled: i in stood(n) is false: stood(2) = []");
  }
}

package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.membership.Short;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexAutomaton.States;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/** The map from events to actions, line by line, and traces that are no runs of the theory. */
class MutexConformanceTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);

  private final ShownRun<States, MutexAction> run = new ShownRun<>(MutexConformance::new);

  private void event(MutexFact event) {
    event("x", event);
  }

  private void event(String xid, MutexFact event) {
    run.has(
        TraceEvent.Action.of(
            0, event.who().robot(), MutexFact.source(xid), MutexFact.SHAPE, event));
  }

  private void ask(ProcessId who, String sections) {
    event(new MutexFact.DoMutex(who, 1, 1, set(sections), new TreeSet<>(Set.of(I, J))));
  }

  private void enter(ProcessId who, String sections) {
    event(new MutexFact.OdMutex(who, 1, set(sections)));
  }

  private void release(ProcessId who, String given, String left) {
    event(new MutexFact.Release(who, 1, set(given), set(left)));
  }

  private static SortedSet<String> set(String names) {
    return Short.sections(names);
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    ask(I, "A B");
    enter(I, "A B");
    release(I, "A", "B");
    ask(J, "A");
    event(new MutexFact.Withdraw(J, 1, MutexFailure.DEADLINE));
    run.has(new Fault(1, I.robot(), Fault.CRASH, ""));
    run.has(new Fault(1, I.robot(), Fault.RESTART, ""));
    event(new MutexFact.StandsIn(ProcessId.first(I.robot(), 2), set("")));
    assertThat(run.steps())
        .containsExactly(
            "do_mutex(i, [A, B])",
            "od_mutex(i, [A, B])",
            "crit_set(i) = [A, B]",
            "release(i, [A])",
            "crit_set(i) = [B]",
            "do_mutex(j, [A])",
            "withdraw(j)",
            "restart(i)",
            "stands_in(i, [])");
    assertThat(run.instances()).containsOnly("mutex/x");
    assertThat(run.details()).isEmpty();
  }

  @Test
  void otherEventsMapToNoAction() {
    ask(I, "A");
    run.forgetSteps();
    event(new MutexFact.Grant(J, I, 1));
    event(new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J))));
    event(new MutexFact.Learned(I, View.closed(List.of(I, J))));
    event(new MutexFact.Fence(I, J, set("")));
    event(new MutexFact.Withdraw(J, 0, MutexFailure.NOT_REGISTERED));
    run.has(new Fault(1, I.robot(), Fault.CRASH, ""));
    run.has(new TraceEvent.Joined(1, J.robot(), new Pose(0, 0, 0), 165));
    run.has(new TraceEvent.Left(1, J.robot()));
    run.has(
        TraceEvent.Action.of(
            1, I.robot(), Instance.APP, Note.SHAPE, new Note("release", List.of("A"))));
    assertThat(run.steps()).isEmpty();
    assertThat(run.details()).isEmpty();
  }

  @Test
  void aRobotThatRejoinsRestartsInEveryInstance() {
    ask(I, "A");
    event("y", new MutexFact.StandsIn(J, set("")));
    run.has(new TraceEvent.Left(1, J.robot()));
    run.forgetSteps();
    run.has(new TraceEvent.Joined(2, J.robot(), new Pose(0, 0, 0), 165));
    assertThat(run.steps()).containsExactly("restart(j)", "restart(j)");
    assertThat(run.instances()).containsExactly("mutex/x", "mutex/y");
  }

  @Test
  void enteringAHeldSectionDeviates() {
    ask(I, "A B");
    enter(I, "A B");
    ask(J, "B");
    enter(J, "B");
    assertThat(run.report().violations())
        .extracting(SpecReport.Violation::toString)
        .containsExactly(
            "Mutex_decls violated at 0.000 s by j: mutex/x: od_mutex(j, [B]) is not enabled:"
                + " free_for?(i, RS) is false: held(i) = [A, B]");
  }

  @Test
  void sectionsOfACrashedRobotAreHeldUntilStandsIn() {
    ask(I, "A B");
    enter(I, "A B");
    run.has(new Fault(1, I.robot(), Fault.CRASH, ""));
    run.has(new Fault(1, I.robot(), Fault.RESTART, ""));
    event(new MutexFact.StandsIn(ProcessId.first(I.robot(), 2), set("B")));
    ask(J, "A");
    enter(J, "A");
    release(J, "A", "");
    assertThat(run.details()).isEmpty();
    ask(J, "B");
    enter(J, "B");
    assertThat(run.details()).hasSize(1);
  }

  @Test
  void aDifferentResultDeviates() {
    ask(I, "A B");
    enter(I, "A B");
    release(I, "A", "");
    assertThat(run.details()).containsExactly("mutex/x: crit_set(i) is [B], but the trace has []");
  }
}

package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.Short;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.PipelineAutomaton.States;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/** The map from events of sequences to actions, and traces that are no runs of the theory. */
class PipelineConformanceTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);

  private ShownRun<States, PipelineAction> run = new ShownRun<>(PipelineConformance::new);

  private void event(MutexFact event) {
    run.has(
        TraceEvent.Action.of(
            0, event.who().robot(), MutexFact.source("x"), MutexFact.SHAPE, event));
  }

  private void asks(ProcessId who, long ts, String... sections) {
    asks(who, ts, false, sections);
  }

  private void asks(ProcessId who, long ts, boolean resumes, String... sections) {
    List<String> all = List.of(sections);
    event(
        new MutexFact.DoMutex(
            who, 1, ts, Sections.copyOf(all), all, resumes, new TreeSet<>(Set.of(I, J))));
  }

  private void enters(ProcessId who, String held) {
    event(new MutexFact.OdMutex(who, 1, Short.sections(held)));
  }

  @Test
  void aSequenceIsGrantedSectionBySection() {
    asks(I, 1, "A", "B");
    enters(I, "A");
    asks(J, 2, "A", "B");
    enters(I, "A B");
    event(new MutexFact.Release(I, 1, Short.sections("A"), Short.sections("B")));
    enters(J, "A");
    assertThat(run.steps())
        .contains("grant(i, A)", "grant(i, B)", "release(i, [A])", "grant(j, A)");
    assertThat(run.report().violations()).isEmpty();
  }

  @Test
  void aSectionThatAnotherHoldsIsNotGranted() {
    asks(I, 1, "A", "B");
    enters(I, "A");
    asks(J, 2, "A", "B");
    enters(J, "A");
    assertThat(run.report().violations())
        .extracting(Violation::lemma)
        .containsExactly("Pipeline_decls");
  }

  @Test
  void aHolderIsNotOvertaken() {
    asks(I, 1, "A", "B");
    enters(I, "A");
    asks(J, 2, "B");
    enters(J, "B");
    assertThat(run.report().violations()).as("B is to be granted to i first").hasSize(1);
  }

  @Test
  void aRobotThatResumesKeepsItsTurnWhenItsBodyHasLeft() {
    for (boolean resumes : List.of(true, false)) {
      run = new ShownRun<>(PipelineConformance::new);
      asks(J, 1, "B");
      enters(J, "B");
      asks(I, 2, "A", "C");
      enters(I, "A");
      run.has(new Fault(0, J.robot(), Fault.RESTART, ""));
      ProcessId again = ProcessId.first(J.robot(), 2);
      asks(again, 3, resumes, "B", "D", "C");
      enters(again, "B D");
      event(new MutexFact.Release(again, 1, Short.sections("B"), Short.sections("D")));
      enters(again, "C D"); // before i, which holds A
      assertThat(run.report().violations()).hasSize(resumes ? 0 : 1);
    }
  }

  @Test
  void aRobotThatAsksAnewWhileItHoldsKeepsThatWhenItsBodyHasLeftTheRest() {
    asks(J, 1, "A", "B");
    enters(J, "A B");
    run.has(new Fault(0, J.robot(), Fault.RESTART, ""));
    ProcessId again = ProcessId.first(J.robot(), 2);
    asks(again, 2, true, "A", "B", "C");
    enters(again, "A B");
    asks(again, 3, true, "C");
    event(new MutexFact.Release(again, 1, Short.sections("A"), Short.sections("B")));
    event(new MutexFact.StandsIn(again, Sections.NONE));
    enters(again, "B C");
    assertThat(run.report().violations()).isEmpty();
    asks(I, 4, "B");
    enters(I, "B");
    assertThat(run.report().violations()).as("B is still held").hasSize(1);
  }

  @Test
  void aRequestThatAResumedRobotMakesLateIsGrantedWhatThatOneDoesNotWaitFor() {
    for (boolean waitsForIt : List.of(false, true)) {
      run = new ShownRun<>(PipelineConformance::new);
      asks(J, 1, "B", "X");
      enters(J, "B X");
      asks(I, 2, "A", "D", "B");
      enters(I, "A"); // and has consents to D already
      run.has(new Fault(0, J.robot(), Fault.RESTART, ""));
      ProcessId again = ProcessId.first(J.robot(), 2);
      asks(again, 3, true, waitsForIt ? new String[] {"B", "D"} : new String[] {"B", "X"});
      enters(again, "B");
      enters(I, "A D");
      assertThat(run.report().violations()).hasSize(waitsForIt ? 1 : 0);
    }
  }

  @Test
  void anIdThatIsGivenUpWaitsNoLonger() {
    event(new MutexFact.Learned(J, View.closed(List.of(I, J))));
    asks(I, 1, "A", "B");
    enters(I, "A");
    asks(J, 2, "B");
    event(new MutexFact.Learned(J, View.closed(List.of(J)).next()));
    enters(J, "B");
    assertThat(run.report().violations()).isEmpty();
    assertThat(run.steps()).contains("withdraw(i)");
  }
}

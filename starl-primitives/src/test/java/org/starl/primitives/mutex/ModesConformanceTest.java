package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.membership.Short;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.ModesAutomaton.States;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;

/** The map from events of a mutex with modes to actions, and traces that are no runs of the theory. */
class ModesConformanceTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);
  private static final ProcessId K = ProcessId.first(new RobotId("k"), 1);

  private final ShownRun<States, ModesAction> run = new ShownRun<>(ModesConformance::new);
  private final Monitors spec = new Monitors(List.of(new MutexSpec().withModes()));

  private void event(MutexFact event) {
    TraceEvent.Action action =
        TraceEvent.Action.of(0, event.who().robot(), MutexFact.source("x"), MutexFact.SHAPE, event);
    run.has(action);
    spec.observe(action);
  }

  private void enters(ProcessId who, String sections) {
    event(
        new MutexFact.DoMutex(who, 1, 1, Short.sections(sections), new TreeSet<>(Set.of(I, J, K))));
    event(new MutexFact.OdMutex(who, 1, Short.sections(sections)));
  }

  private void assertFound(String lemma) {
    assertThat(run.report().violations())
        .extracting(Violation::lemma)
        .containsExactly("Modes_decls");
    assertThat(spec.report().violations(lemma)).isPositive();
  }

  @Test
  void robotsShareASectionInOneMode() {
    enters(I, "A/e B");
    enters(J, "A/e");
    event(new MutexFact.Release(I, 1, Short.sections("A/e"), Short.sections("B")));
    event(new MutexFact.Release(J, 1, Short.sections("A/e"), Short.sections("")));
    enters(K, "A/w");
    assertThat(run.steps()).contains("grant(i, A/e, 0)", "grant(j, A/e, 0)", "grant(k, A/w, 0)");
    assertThat(run.report().violations()).isEmpty();
  }

  @Test
  void aRemovedProcessMayEnterWhatItsEarlierOneHeld() {
    enters(I, "A/e");
    ProcessId next = ProcessId.first(I.robot(), 2);
    run.has(new TraceEvent.Fault(0, I.robot(), TraceEvent.Fault.RESTART, ""));
    event(new MutexFact.StandsIn(next, Short.sections("A/e")));
    SortedSet<String> sections = Short.sections("A/e");
    event(
        new MutexFact.DoMutex(
            next, 1, 1, sections, List.of("A/e"), true, new TreeSet<>(Set.of(J))));
    event(new MutexFact.Learned(J, View.closed(List.of(J)).next()));
    event(new MutexFact.OdMutex(next, 1, sections));
    assertThat(run.report().violations()).isEmpty();
  }

  @Test
  void twoModesTogetherAreFound() {
    enters(I, "A/e");
    enters(J, "A/w");
    assertFound("mutex.Exclusive");
  }

  @Test
  void aModeBesideARobotThatIsAloneIsFound() {
    enters(I, "A");
    enters(J, "A/w");
    assertFound("mutex.Exclusive");
  }

  @Test
  void eachRobotHasAPlaceOfItsOwn() {
    enters(I, "A/e*2");
    enters(J, "A/e*2");
    event(new MutexFact.Release(I, 1, Short.sections("A/e*2"), Short.sections("")));
    enters(K, "A/e*2");
    assertThat(run.steps())
        .contains("grant(i, A/e*2, 0)", "grant(j, A/e*2, 1)", "grant(k, A/e*2, 0)");
    assertThat(run.report().violations()).isEmpty();
  }

  @Test
  void oneRobotTooManyIsFound() {
    enters(I, "A/e*2");
    enters(J, "A/e*2");
    enters(K, "A/e*2");
    assertFound("mutex.Capacity");
  }
}

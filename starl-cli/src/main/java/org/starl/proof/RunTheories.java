package org.starl.proof;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.primitives.agreement.AgreementAutomaton;
import org.starl.primitives.agreement.AgreementConformance;
import org.starl.primitives.election.ElectionAutomaton;
import org.starl.primitives.election.ElectionConformance;
import org.starl.primitives.mutex.MutexAutomaton;
import org.starl.primitives.mutex.MutexConformance;
import org.starl.primitives.registration.RegistrationAutomaton;
import org.starl.primitives.registration.RegistrationConformance;
import org.starl.proof.Expressions.Formal;
import org.starl.sim.SimObserver;
import org.starl.spec.Monitors;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes a run as PVS theories when it is closed, one for each instance of a mutex, a registration,
 * an agreement or an election. For {@code starl run --pvs FILE}.
 */
public final class RunTheories implements SimObserver, Closeable {

  private final OutputStream out;
  private final Map<Instance, RunTheory> theories = new TreeMap<>();
  private final Monitors monitors;
  private String run = "A run";
  private long endNs;

  public RunTheories(OutputStream out) {
    this.out = out;
    Formal robots = new Formal("PIDS", RobotId.class);
    Formal ids = new Formal("PIDS", ProcessId.class);
    Formal zones = new Formal("Zones", String.class);
    Formal values = new Formal("Values", String.class);
    monitors =
        new Monitors(
            List.of(
                new MutexConformance(steps(new MutexAutomaton(), ids, zones)),
                new RegistrationConformance(steps(new RegistrationAutomaton(), ids)),
                new AgreementConformance(steps(new AgreementAutomaton(), robots, values)),
                new ElectionConformance(steps(new ElectionAutomaton(), ids))));
  }

  private <S extends Record, A extends Action> AutomatonListener<S, A> steps(
      Automaton<S, A> automaton, Formal... formals) {
    return new AutomatonListener<>() {
      @Override
      public void onStep(Instance instance, TraceEvent event, A action, S after) {
        theory(instance).stepped(event, action, after);
      }

      @Override
      public void onResult(Instance instance, String function, Object argument, Object value) {
        theory(instance).resulted(function, argument, value);
      }

      private RunTheory theory(Instance instance) {
        return theories.computeIfAbsent(
            instance,
            name ->
                new RunTheory(
                    name.name(), automaton.theory(), List.of(formals), automaton.start()));
      }
    };
  }

  @Override
  public void started(TraceHeader header) {
    run = header.scenario() + ", seed " + header.scenarioSeed();
  }

  @Override
  public void observed(TraceEvent event) {
    endNs = event.timeNs();
    monitors.observe(event);
  }

  /**
   * Writes the theories.
   *
   * @throws BadInput if the run used none of these primitives
   */
  @Override
  public void close() throws IOException {
    monitors.finish(endNs);
    if (theories.isEmpty()) {
      throw new BadInput(
          "--pvs: this run has no primitive with a theory in pvs/: expected an app that uses a"
              + " mutex, a registration, an agreement or an election");
    }
    StringBuilder text = new StringBuilder();
    for (RunTheory theory : theories.values()) {
      text.append(text.length() == 0 ? "" : "\n").append(theory.text(run));
    }
    out.write(text.toString().getBytes(StandardCharsets.UTF_8));
    out.close();
  }
}

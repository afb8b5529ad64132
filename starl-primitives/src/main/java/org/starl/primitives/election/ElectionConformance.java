package org.starl.primitives.election;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.election.ElectionAutomaton.Known;
import org.starl.primitives.election.ElectionAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Replay;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every election is a run of the theory {@code Election_decls}. The facts {@code
 * do_election} and {@code candidate} are actions of the theory, if their id is one of the event's
 * robot. The map of other events to actions, where {@code i} is the id that the event's robot announced
 * last:
 *
 * <pre>
 * event                            action
 * Election size i                  none: the robot announces its id i
 * Leader n:j, for the first time   elect(n, j): the decision itself is not in the trace
 * Leader n:j                       learn(i, n); Leader(i) is j in term n
 * Leader fail                      fail(i); Leader(i) is none
 * Leader null                      fail(i), if i knew a leader: a new term began, or the robot's
 *                                  program started again
 * all other events                 none
 * </pre>
 *
 * <p>A robot that has announced no id learns for no id; the leader that it shows must be the elected
 * one all the same. Memory grows with the ids, and with the candidates and leaders of all terms.
 */
public final class ElectionConformance extends Conformance<ElectionConformance.Run> {

  /** One instance: its replay, and each robot's present id. */
  record Run(Replay<States, ElectionAction> replay, Map<RobotId, ProcessId> ids) {}

  public ElectionConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public ElectionConformance(AutomatonListener<States, ElectionAction> steps) {
    super(
        ElectionAutomaton.ELECTION_DECLS,
        "every election",
        source -> new Run(new Replay<>(new ElectionAutomaton(), source, steps), new TreeMap<>()),
        ElectionFact.PRIMITIVE);
  }

  @Override
  protected void acted(Action action, Report report) {
    Run run = instance(action.source());
    switch (action.fact()) {
      case ElectionFact.Created created -> run.ids.put(action.robot(), created.i());
      case ElectionAction step when action.process() != null ->
          run.replay.step(action, step, report);
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    Leader leader = variable.of(ElectionFact.LEADER);
    if (leader == null) {
      return;
    }
    Run run = instance(variable.source());
    ProcessId i = run.ids.get(variable.robot());
    if (leader instanceof Leader.Name name) {
      learn(variable, i, name, run.replay, report);
    } else if (i != null
        && (leader.equals(Leader.FAIL) || run.replay.state().Leader().at(i).who().isUp())) {
      run.replay.step(variable, new ElectionAction.fail(i), report);
      Known shown = run.replay.state().Leader().at(i);
      Known recorded = new Known(shown.term(), new Lift.bottom<>()); // the trace has no term here
      run.replay.result(variable, "Leader", i, recorded, shown, report);
    }
  }

  private static void learn(
      Variable event,
      @Nullable ProcessId i,
      Leader.Name leader,
      Replay<States, ElectionAction> replay,
      Report report) {
    long term = leader.term();
    if (!replay.state().elected().at(term).isUp()) {
      replay.step(event, new ElectionAction.elect(term, leader.id()), report);
    }
    Lift<ProcessId> who = new Lift.up<>(leader.id());
    if (i == null) {
      replay.result(event, "elected", term, who, replay.state().elected().at(term), report);
    } else {
      replay.step(event, new ElectionAction.learn(i, term), report);
      replay.result(
          event, "Leader", i, new Known(term, who), replay.state().Leader().at(i), report);
    }
  }
}

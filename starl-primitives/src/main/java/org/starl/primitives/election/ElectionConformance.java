package org.starl.primitives.election;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.primitives.election.ElectionAutomaton.Known;
import org.starl.primitives.election.ElectionAutomaton.States;
import org.starl.spec.Dues.Seat;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Replays;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every election is a run of the theory {@code Election_decls}: the lemma is its name.
 * What happens is taken for an action of the theory so, {@code i} being the id that its robot's
 * program said last that it has:
 *
 * <pre>
 * event                              action
 * Election size i                    stutter: the robot is i from now on
 * do_election i                      do_election(i), by its own robot's word
 * candidate n i                      candidate(i, n), by its own robot's word
 * Leader n:j, as the first to know   elect(n, j): nobody tells when a term is decided
 * Leader n:j                         learn(i, n), Leader(i) is j in term n
 * Leader fail                        fail(i)
 * Leader null                        fail(i), if i knew a leader: another term has begun, or its robot's
 *                                    program anew; else a stutter
 * all other events                   stutter
 * </pre>
 *
 * <p>A robot that has not said who it is learns for nobody; whom it shows is the one elected all the
 * same. What is kept are all ids, and who stood and was elected in each term.
 */
public final class ElectionConformance extends Conformance {

  private final Replays<States, ElectionAction> replays;
  private final Map<Seat, ProcessId> ids = new LinkedHashMap<>();

  public ElectionConformance() {
    this(Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step of every instance
   */
  public ElectionConformance(Steps<States, ElectionAction> steps) {
    super(ElectionAutomaton.ELECTION_DECLS, "every election");
    replays = new Replays<>(new ElectionAutomaton(), steps);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case Action action when ElectionTrace.isElection(action.source()) -> acted(action, report);
      case Variable variable
          when ElectionTrace.isElection(variable.source())
              && variable.name().equals(ElectionTrace.LEADER) ->
          shown(variable, replays.of(variable.source()), report);
      default -> {
        // A stutter.
      }
    }
  }

  private void acted(Action action, Report report) {
    List<String> args = action.args();
    switch (action.name()) {
      case ElectionTrace.ELECTION ->
          ids.put(new Seat(action.source(), action.robot()), ProcessId.parse(args.get(1)));
      case ElectionTrace.DO_ELECTION -> {
        ProcessId i = ProcessId.parse(args.get(0));
        does(action, i, new ElectionAction.do_election(i), report);
      }
      case ElectionTrace.CANDIDATE -> {
        ProcessId i = ProcessId.parse(args.get(1));
        does(action, i, new ElectionAction.candidate(i, Long.parseLong(args.get(0))), report);
      }
      default -> {
        // A stutter.
      }
    }
  }

  private void does(Action event, ProcessId i, ElectionAction action, Report report) {
    if (i.robot().equals(event.robot())) {
      replays.of(event.source()).step(event, action, report);
    }
  }

  private void shown(Variable variable, Replay<States, ElectionAction> replay, Report report) {
    ProcessId i = ids.get(new Seat(variable.source(), variable.robot()));
    Leader leader = Leader.parse(variable.value());
    if (leader instanceof Leader.Name name) {
      follows(variable, i, name.term(), name.id(), replay, report);
    } else if (i != null
        && (leader.equals(Leader.FAIL) || replay.state().Leader().at(i).who().isUp())) {
      replay.step(variable, new ElectionAction.fail(i), report);
    }
  }

  private static void follows(
      Variable event,
      @Nullable ProcessId i,
      long term,
      ProcessId leader,
      Replay<States, ElectionAction> replay,
      Report report) {
    if (!replay.state().elected().at(term).isUp()) {
      replay.step(event, new ElectionAction.elect(term, leader), report);
    }
    Lift<ProcessId> who = new Lift.up<>(leader);
    if (i == null) {
      replay.result(event, "elected", term, who, replay.state().elected().at(term), report);
    } else {
      replay.step(event, new ElectionAction.learn(i, term), report);
      replay.result(
          event, "Leader", i, new Known(term, who), replay.state().Leader().at(i), report);
    }
  }
}

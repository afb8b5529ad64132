package org.starl.primitives.barrier;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of every barrier is a run of the theory {@code Barrier_decls}: the lemma is its name.
 * What happens is taken for an action of the theory so, {@code i} being the id that its robot's
 * program said last that it has:
 *
 * <pre>
 * event                              action
 * Barrier i members                  stutter: the robot is i from now on; the first one's members are
 *                                    the parameter first, and all others' are the same
 * arrive g i                         arrive(i, g), by its own robot's word
 * outcome g:passed, g:failed[M],
 *   as the first to know             decide(g, passed), decide(g, failed(M))
 * outcome g:passed, g:failed[M]      tell(i, g), told(i) is this
 * outcome g:excluded                 tell(i, g), told(i) is failed(M), and i is in M
 * outcome null, 0:excluded,
 *   g:unknown                        stutter: who never was a member, or knows nothing, is told nothing
 * all other events                   stutter, and so are all before the instance's first Barrier
 * </pre>
 *
 * <p>Nobody tells when a generation is decided: it is taken for decided when somebody is first told
 * its outcome. Generations are told in order, since only who was told of one arrives in the next.
 * Who is told {@code excluded} does not tell who else is: where nobody has told the outcome yet, its
 * {@code tell} waits for it, or for the end of the run, when those who were told so are taken to be
 * all who were left out. That is a run of the theory if any is: nothing else asks for that outcome.
 *
 * <p>What is kept are all ids and outcomes, and who arrived in generations without one.
 */
public final class BarrierConformance extends Conformance {

  private final Steps<States, BarrierAction> steps;
  private final Map<String, BarrierRun> runs = new TreeMap<>();

  public BarrierConformance() {
    this(Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step of every instance
   */
  BarrierConformance(Steps<States, BarrierAction> steps) {
    super(BarrierAutomaton.BARRIER_DECLS, "every barrier");
    this.steps = steps;
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case Action action when BarrierTrace.isBarrier(action.source()) -> acted(action, report);
      case Variable variable
          when BarrierTrace.isBarrier(variable.source())
              && variable.name().equals(BarrierTrace.OUTCOME) -> {
        BarrierRun run = runs.get(variable.source());
        if (run != null) {
          run.shows(variable, report);
        }
      }
      default -> {
        // A stutter.
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    runs.values().forEach(run -> run.finish(report));
  }

  private void acted(Action action, Report report) {
    List<String> args = action.args();
    if (action.name().equals(BarrierTrace.BARRIER)) {
      SortedSet<ProcessId> members = new TreeSet<>();
      args.subList(1, args.size()).forEach(id -> members.add(ProcessId.parse(id)));
      SortedSet<ProcessId> first = Collections.unmodifiableSortedSet(members);
      runs.computeIfAbsent(action.source(), source -> new BarrierRun(source, first, steps))
          .made(action, ProcessId.parse(args.get(0)), first, report);
      return;
    }
    BarrierRun run = runs.get(action.source());
    if (run != null && action.name().equals(BarrierTrace.ARRIVE)) {
      run.arrives(action, Long.parseLong(args.get(0)), ProcessId.parse(args.get(1)), report);
    }
  }
}

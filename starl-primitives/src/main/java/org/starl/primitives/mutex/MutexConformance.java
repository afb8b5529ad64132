package org.starl.primitives.mutex;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.MutexAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * Every run of every mutex is a run of the theory {@code Mutex_decls}. A fact that has an {@link
 * MutexFact#action} is that action; after an access or a release, {@code crit_set(i)} is
 * what the fact says. The other events:
 *
 * <pre>
 * event                action, where i is the event's robot
 * fault restart        restart(i) in every instance
 * joined               restart(i) in every instance, if the robot had left before
 * fault crash, left    none: the robot still holds what it held
 * all others           none
 * </pre>
 *
 * <p>All participants of a robot are one process of the theory, named by the robot's first id. An older
 * participant may still hold sections; its {@code crit_set(i)} remains, and the robot requests
 * nothing until it has released them. Time per step, and memory, grow with the robots that hold or
 * wait.
 */
public final class MutexConformance extends Conformance<Replay<States, MutexAction>> {

  private final Set<RobotId> gone = new TreeSet<>();
  // Those with sequences or modes, which are runs of other theories.
  private final Set<Instance> ofOthers = new LinkedHashSet<>();

  public MutexConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public MutexConformance(AutomatonListener<States, MutexAction> steps) {
    super(
        MutexAutomaton.MUTEX_DECLS,
        "every mutex",
        source -> new Replay<>(new MutexAutomaton(), source, steps),
        MutexFact.PRIMITIVE);
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    switch (event) {
      case Fault fault when fault.name().equals(Fault.RESTART) -> restart(fault, report);
      case TraceEvent.Left left -> gone.add(left.robot());
      case TraceEvent.Joined joined when gone.remove(joined.robot()) -> restart(joined, report);
      default -> {}
    }
  }

  private void restart(TraceEvent event, Report report) {
    // An instance without events yet has no replay; there a restart would change nothing.
    instances()
        .values()
        .forEach(
            replay -> replay.step(event, new MutexAction.restart(process(event.robot())), report));
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    // The run of an instance begins with its first action: other facts are no actions.
    if (action.fact() instanceof MutexFact.DoMutex request
        && (!request.sequence().isEmpty() || Sections.haveMode(request.want()))) {
      ofOthers.add(action.source());
    }
    if (ofOthers.contains(action.source())) {
      return;
    }
    if (action.fact() instanceof MutexFact fact && fact.action().isPresent()) {
      instance(action.source()).step(action, fact.action().get(), report);
      switch (fact) {
        case MutexFact.OdMutex access -> holds(action, access.who(), access.held(), report);
        case MutexFact.Release release -> holds(action, release.who(), release.left(), report);
        default -> {}
      }
    }
  }

  private void holds(
      TraceEvent.Action action, ProcessId who, SortedSet<String> held, Report report) {
    Replay<States, MutexAction> replay = instance(action.source());
    ProcessId i = process(who.robot());
    replay.result(action, "crit_set", i, held, replay.state().crit_set().at(i), report);
  }

  static ProcessId process(RobotId robot) {
    return ProcessId.first(robot, 1);
  }
}

package org.starl.primitives.mutex;

import java.util.Set;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * Every run of every mutex is a run of the theory {@code Mutex_decls}. The map from events to
 * actions, where {@code i} is the robot of {@code who}:
 *
 * <pre>
 * event                         action
 * do_mutex who num ts want ...  do_mutex(i, want)
 * od_mutex who num held         od_mutex(i, held); crit_set(i) is held
 * release who num given left    release(i, given); crit_set(i) is left
 * withdraw who num why          withdraw(i); none if num is 0: the request never began
 * stands_in who sections        stands_in(i, sections)
 * fault restart                 restart(i) in every instance
 * joined                        restart(i) in every instance, if the robot had left before
 * fault crash, left             none: the robot still holds what it held
 * grant, known, view, fence     none: the theory has no agreement protocol
 * all other events              none
 * </pre>
 *
 * <p>All participants of one start of a robot's program are one process of the theory. An older
 * participant may still hold sections; its {@code crit_set(i)} remains, and the robot requests
 * nothing until it has released them. Time per step, and memory, grow with the robots that hold or
 * wait.
 */
public final class MutexConformance extends Conformance<Replay<States, MutexAction>> {

  private final Set<RobotId> gone = new TreeSet<>();

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
        MutexTrace::isMutex,
        source -> new Replay<>(new MutexAutomaton(), source, steps));
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
        .forEach(replay -> replay.step(event, new MutexAction.restart(event.robot()), report));
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    if (MutexTrace.isOfAccess(action)) {
      MutexTrace.read(action)
          .ifPresent(read -> step(action, read, instance(action.source()), report));
    }
  }

  private static void step(
      TraceEvent event, MutexEvent read, Replay<States, MutexAction> replay, Report report) {
    RobotId i = read.who().robot();
    switch (read) {
      case MutexEvent.DoMutex e ->
          replay.step(event, new MutexAction.do_mutex(i, e.want()), report);
      case MutexEvent.OdMutex e -> {
        replay.step(event, new MutexAction.od_mutex(i, e.held()), report);
        replay.result(event, "crit_set", i, e.held(), replay.state().crit_set().at(i), report);
      }
      case MutexEvent.Release e -> {
        replay.step(event, new MutexAction.release(i, e.given()), report);
        replay.result(event, "crit_set", i, e.left(), replay.state().crit_set().at(i), report);
      }
      case MutexEvent.Withdraw e -> {
        if (e.num() != 0) {
          replay.step(event, new MutexAction.withdraw(i), report);
        }
      }
      case MutexEvent.StandsIn e ->
          replay.step(event, new MutexAction.stands_in(i, e.sections()), report);
      default -> {}
    }
  }
}

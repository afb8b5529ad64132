package org.starl.primitives.mutex;

import java.util.Set;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexAutomaton.States;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Replays;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * Every run of every mutex is a run of the theory {@code Mutex_decls}: the lemma is its name. What
 * happens is taken for an action of the theory so, {@code i} being the robot of {@code who}:
 *
 * <pre>
 * event                         action
 * do_mutex who num ts want ...  do_mutex(i, want)
 * od_mutex who num held         od_mutex(i, held), crit_set(i) is held
 * release who num given left    release(i, given), crit_set(i) is left
 * withdraw who num why          withdraw(i); a stutter if num is 0: no request had begun
 * stands_in who sections        stands_in(i, sections)
 * fault restart                 restart(i) in every instance
 * joined                        restart(i) as well, if the robot had left before
 * fault crash, left             stutter: what it held it still holds
 * grant, known, view, fence     stutter: how access is agreed upon is no matter of this theory
 * all other events              stutter
 * </pre>
 *
 * <p>A robot's participants of one start are one process of the theory: of an older one that lingers,
 * because it still holds something, {@code crit_set(i)} goes on, and the robot asks for nothing until
 * that is given back. A step costs time in the number of robots that hold or wait, and so much is kept.
 */
public final class MutexConformance extends Conformance {

  private final Replays<States, MutexAction> replays;
  private final Set<RobotId> gone = new TreeSet<>();

  public MutexConformance() {
    this(Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step of every instance
   */
  public MutexConformance(Steps<States, MutexAction> steps) {
    super(MutexAutomaton.MUTEX_DECLS, "every mutex");
    replays = new Replays<>(new MutexAutomaton(), steps);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case TraceEvent.Action action -> acted(action, report);
      case Fault fault when fault.name().equals(Fault.RESTART) -> restarts(fault, report);
      case TraceEvent.Left left -> gone.add(left.robot());
      case TraceEvent.Joined joined when gone.remove(joined.robot()) -> restarts(joined, report);
      default -> {
        // A stutter.
      }
    }
  }

  private void restarts(TraceEvent event, Report report) {
    // Where nothing has happened yet, it changes nothing.
    replays.forEach(replay -> replay.step(event, new MutexAction.restart(event.robot()), report));
  }

  private void acted(TraceEvent.Action action, Report report) {
    if (MutexTrace.isOfAccess(action)) {
      MutexTrace.read(action)
          .ifPresent(read -> acted(action, read, replays.of(action.source()), report));
    }
  }

  private static void acted(
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
      case MutexEvent.Grant e -> {
        // A stutter, and so are these.
      }
      case MutexEvent.Known e -> {}
      case MutexEvent.Learned e -> {}
      case MutexEvent.Fence e -> {}
    }
  }
}

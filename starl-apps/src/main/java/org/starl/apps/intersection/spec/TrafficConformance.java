package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.registration.RegistrationAction;
import org.starl.primitives.registration.RegistrationFact;
import org.starl.spec.LemmaMonitor;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * Every run of an intersection of cars after Figure 4 is a run of the theory {@code Traffic_decls}, the
 * composition of registration, mutex and cars. A process of the theory is one id of a robot. The map
 * from events to actions:
 *
 * <pre>
 * event                                    action, where i is an id of the event's robot
 * registration: do_register i              arrive(i), or restart(i, j) if the robot's earlier id j
 *                                          was among the zones; do_register(i); and learn(i, n) if
 *                                          its robot knows list n; if an earlier id of the robot is past
 *                                          register_wait, has not given up and was not ended by a
 *                                          restart, do_register of that id
 * registration: unregister i               unregister(i); give_up(i), if a program that restarted
 *                                          past the zones never asked for any
 * registration: give_up i                  give_up(i); unregister(i), if i is past its last zone;
 *                                          none, if i has left the list, or has given up
 * restart of the robot                     give_up(i) of its id that asks for zones, or holds them
 * registration: confine j, by its own      the same of j, an earlier id
 * robot, or with those who vouch for j
 * registration: view n, for the first time decide(L), if L is not the list before
 * registration: view n                     learn(i, m), m being the number of the list of view n, if
 *                                          it is a newer one; rList(i) is L
 * mutex: do_mutex i, RS                    skip(i) for each zone that i has restarted behind, and
 *                                          do_mutex(i, RS); plist(i) is known
 * mutex: known i                           none; plist(i) is known, while i waits
 * mutex: od_mutex i, RS                    od_mutex(i, RS)
 * mutex: withdraw i                        withdraw(i), if i has not given up
 * mutex: stands_in RS                      stands_in(i, RS), i being the robot's id that registered
 *                                          last; before it towed(i), if the car is off the road
 * mutex: release i, RS                     release(i, RS); crit_set(i) is what the fact says is left
 * any of these, of any car; a movement     advance(i) of each car whose true body is in a later zone
 * any of these, after time has passed      dt
 * all others                               none
 * </pre>
 *
 * <p>A car is in a zone until its whole true body has left it; and past the last zone when it is in
 * none. A zone that is given back late is behind: the theory's car advances by one zone for each that is
 * given back. Bodies are looked at when an action is taken, and when they move in another way; {@link
 * TrafficSafety} looks at them at all times. The bounds B, R, G and T are never reached: {@link TrafficProgress} bounds the time.
 *
 * <p>A robot that restarts takes another id: the earlier one acts no more, as in the theory. What it held
 * is kept for its car, which goes on under the next id. But in the theory no car acts under an id that was
 * given up. So the replay ends, and the report says so ({@link #inPart}), when others give up a car that
 * holds zones and has not crashed; and when others have given up a car that then asks for zones, or is
 * granted them. Runs in real time are not replayed: bodies are measured there, with errors.
 */
public final class TrafficConformance extends LemmaMonitor {

  private final Instance mutex;
  private final Instance registration;
  private final TrafficRun run;
  private final Map<RobotId, List<String>> ways = new TreeMap<>();
  private boolean hasEnded;

  /** Of the intersection {@code xid}. */
  public TrafficConformance(String xid) {
    mutex = MutexFact.source(xid);
    registration = Instance.of(RegistrationFact.PRIMITIVE, xid);
    run = new TrafficRun(Instance.of("intersection", xid), this::way);
    lemma(
        TrafficAutomaton.TRAFFIC_DECLS,
        "The run of the intersection is one of the theory's automaton, step by step.");
  }

  private List<String> way(RobotId car) {
    return ways.getOrDefault(car, List.of());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (hasEnded) {
      return;
    }
    run.observe(event, report);
    CrossingFact.trip(event).ifPresent(trip -> ways.putIfAbsent(event.robot(), trip.zones()));
    switch (event) {
      case Fault fault when fault.name().equals(Fault.CRASH) -> run.crashes(event.robot());
      case Fault fault when fault.name().equals(Fault.RESTART) -> run.restarts(event, report);
      case Fault fault when fault.isRealTime() -> {
        hasEnded = true;
        never(TrafficAutomaton.TRAFFIC_DECLS, "in real time bodies are measured, with errors");
      }
      case Action action when action.source().equals(mutex) -> ofMutex(action, report);
      case Action action when action.source().equals(registration) ->
          ofRegistration(action, report);
      case Variable variable when variable.source().equals(registration) -> {
        View view = variable.of(RegistrationFact.VIEW);
        if (view != null && view.number() > 0 && !run.saw(event, view, report)) {
          end(event, event.robot() + " shows a list after later ones");
        }
      }
      default -> {
        // No action of the theory.
      }
    }
  }

  private void end(TraceEvent event, String what) {
    hasEnded = true;
    ends(TrafficAutomaton.TRAFFIC_DECLS, what + " at " + Time.text(event.timeNs(), 3));
  }

  private void ofRegistration(Action action, Report report) {
    switch (action.fact()) {
      case RegistrationAction.do_register asked -> run.registers(action, asked.i(), report);
      case RegistrationAction.unregister left -> run.unregisters(action, left.i(), report);
      case RegistrationAction.give_up id -> givesUp(action, id.i(), report);
      case Confinement confinement when confinement.isSaidBy(action.robot()) ->
          givesUp(action, confinement.who(), report);
      default -> {
        // The acceptors.
      }
    }
  }

  private void givesUp(Action action, ProcessId i, Report report) {
    if (!run.givesUp(action, i, report)) {
      end(action, i + " is given up while it holds zones");
    }
  }

  private void ofMutex(Action action, Report report) {
    switch (action.fact()) {
      case MutexFact.DoMutex f when !f.sequence().isEmpty() ->
          end(action, f.who() + " asks for a sequence");
      case MutexFact.DoMutex f when run.isGivenUpByOthers(f.who()) ->
          end(action, f.who() + " asks for zones after others gave it up");
      case MutexFact.OdMutex f when run.isGivenUpByOthers(f.who()) ->
          end(action, f.who() + " is granted zones after others gave it up");
      case MutexFact.DoMutex f -> {
        run.asksFor(action, f.who(), f.want(), report);
        run.asks(action, f.who(), f.known(), report);
      }
      case MutexFact.Known f -> run.asks(action, f.who(), f.known(), report);
      case MutexFact.OdMutex f ->
          run.step(action, new TrafficAction.od_mutex(f.who(), f.held()), report);
      case MutexFact.Release f -> {
        run.step(action, new TrafficAction.release(f.who(), f.given()), report);
        run.holds(action, f.who(), f.left(), report);
      }
      case MutexFact.StandsIn f -> run.standsIn(action, f.sections(), report);
      case MutexFact.Withdraw f when f.num() > 0 -> run.withdraws(action, f.who(), report);
      default -> {
        // Of the protocol.
      }
    }
  }
}

package org.starl.primitives.geocast;

import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.primitives.geocast.GeocastAutomaton.States;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Replays;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * Every run of every geocast and broadcast is a run of the theory {@code Geocast_decls}: the lemma is
 * its name. What happens is taken for an action of the theory so, {@code i} being the event's robot:
 *
 * <pre>
 * event                          action
 * do_geocast m A d, BCast m A d  move(j, also in A) for each j whose body is in A, do_geocast(m, A, d)
 * a body enters A for the first  move(i, also in A)
 *   time in the interval
 * deliver m                      deliver(m, i)
 * open                           restart(i)
 * all other events               stutter, so is a body that leaves A
 * before each of these           dt, the time since the last of them
 * </pre>
 *
 * <p>Bodies are the true ones, and who is in A is decided as {@link GeocastSpec} does, with its
 * tolerances; but at a delivery, where that looks at the whole interval. That a body enters is found
 * at its next event or delivery, and its step comes then. To leave is a stutter since {@code was_in}
 * stays, and only {@code was_out}, which enables nothing, would change. A place is known by the areas
 * that it is in, and of an area nobody asks before its geocast: hence the moves at that time. Whose
 * body has never been seen is taken to be in A.
 *
 * <p>A message is forgotten when its interval is over, which whoever is handed it then is told: memory
 * is for what is open.
 */
public final class GeocastConformance extends Conformance {

  // How deep inside a body is decides nothing here.
  private final Casts casts = new Casts(Double.POSITIVE_INFINITY);
  private final Replays<States, GeocastAction> replays;

  public GeocastConformance() {
    this(Steps.ignored());
  }

  /**
   * The same.
   *
   * @param steps takes every step of every instance
   */
  GeocastConformance(Steps<States, GeocastAction> steps) {
    super(GeocastAutomaton.GEOCAST_DECLS, "every geocast");
    replays = new Replays<>(new GeocastAutomaton(), steps);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    casts.observe(
        event,
        new Casts.Listener() {
          @Override
          public void entered(CastRecord cast, RobotId robot) {
            // Beyond the interval it is forgotten next.
            if (event.timeNs() <= cast.deadlineNs) {
              enters(event, cast, robot, report);
            }
          }

          @Override
          public void over(CastRecord cast) {
            replays.of(cast.source).forget(s -> s.without(cast.id));
          }
        });
    if (event instanceof Action action && GeocastTrace.isGeocast(action.source())) {
      acted(action, report);
    }
  }

  private void enters(TraceEvent event, CastRecord cast, RobotId robot, Report report) {
    Replay<States, GeocastAction> replay = replays.of(cast.source);
    SortedSet<String> place = Sets.add(cast.id, replay.state().pos().at(robot));
    step(event, new GeocastAction.move(robot, place), replay, report);
  }

  private void acted(Action action, Report report) {
    Replay<States, GeocastAction> replay = replays.of(action.source());
    switch (action.name()) {
      case GeocastTrace.OPEN ->
          step(action, new GeocastAction.restart(action.robot()), replay, report);
      case GeocastTrace.DO_GEOCAST, GeocastTrace.B_CAST -> {
        String m = action.args().get(0);
        long bound = Long.parseLong(action.args().get(2));
        step(action, new GeocastAction.do_geocast(m, m, bound), replay, report);
      }
      case GeocastTrace.DELIVER -> {
        CastRecord cast = casts.of(action);
        if (cast != null && !cast.hasSeen(action.robot())) {
          enters(action, cast, action.robot(), report);
        }
        step(
            action,
            new GeocastAction.deliver(action.args().get(0), action.robot()),
            replay,
            report);
      }
      default -> {
        // A stutter.
      }
    }
  }

  private static void step(
      TraceEvent event, GeocastAction action, Replay<States, GeocastAction> replay, Report report) {
    long passedNs = event.timeNs() - replay.state().now();
    if (passedNs > 0) {
      replay.step(event, new GeocastAction.dt(passedNs), report);
    }
    replay.step(event, action, report);
  }
}

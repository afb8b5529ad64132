package org.starl.primitives.geocast;

import org.starl.id.RobotId;
import org.starl.primitives.geocast.GeocastAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Sets;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * Every run of every geocast and broadcast is a run of the theory {@code Geocast_decls}. The map
 * from events to actions, where {@code i} is the event's robot:
 *
 * <pre>
 * event                          action
 * do_geocast m A d, BCast m A d  move(j, also in A) for each j whose body is in A, do_geocast(m, A, d)
 * a body enters A for the first
 *   time in the interval         move(i, also in A)
 * deliver m                      deliver(m, i)
 * open                           restart(i)
 * all other events               none; none also for a body that leaves A
 * before each of these           dt, the time since the last of them
 * </pre>
 *
 * <p>Bodies are the true ones. Whether a body is in A is decided with the tolerances of {@link
 * GeocastSpec}; a delivery alone is judged at once, where the specification looks at the whole
 * interval. An entry is found at the body's next event or delivery, and its step comes then.
 * Leaving A is no action: {@code was_in} remains, and {@code was_out}, which would change, enables
 * nothing. A place is represented by the areas that contain it, and an area matters only from its
 * geocast on: hence the moves at that time. A robot whose body was never seen is taken to be in A.
 * Every place is in the area of a broadcast: no robot moves into it.
 *
 * <p>A message is forgotten at the end of its interval, and a later delivery says so. Memory grows
 * with the open messages only.
 */
public final class GeocastConformance extends Conformance<Replay<States, GeocastAction>> {

  // The depth inside the area decides nothing here.
  private final Casts casts =
      new Casts(
          Double.POSITIVE_INFINITY,
          new Casts.Listener() {
            @Override
            public void entered(CastRecord cast, RobotId robot, TraceEvent event, Report report) {
              enter(event, cast, robot, report);
            }

            @Override
            public void over(CastRecord cast, Report report) {
              instance(cast.source).reduce(s -> without(cast.id.toString(), s));
            }
          });

  public GeocastConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  GeocastConformance(AutomatonListener<States, GeocastAction> steps) {
    super(
        GeocastAutomaton.GEOCAST_DECLS,
        "every geocast",
        source -> new Replay<>(new GeocastAutomaton(), source, steps),
        GeocastFact.GEOCAST,
        GeocastFact.BROADCAST);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    casts.observe(event, report);
    super.observe(event, report);
  }

  private void enter(TraceEvent event, CastRecord cast, RobotId robot, Report report) {
    Replay<States, GeocastAction> replay = instance(cast.source);
    Place place = replay.state().pos().at(robot).in(Area.of(cast.id));
    step(event, new GeocastAction.move(robot, place), replay, report);
  }

  @Override
  protected void acted(Action action, Report report) {
    if (!(action.fact() instanceof GeocastFact fact)) {
      return;
    }
    RobotId i = action.robot();
    if (fact instanceof GeocastFact.deliver delivery) {
      CastRecord cast = casts.of(action.source(), delivery.m());
      if (cast != null && !cast.isEverywhere() && !cast.bodies.hasSeen(i)) {
        enter(action, cast, i, report);
      }
    }
    GeocastAction taken = GeocastFact.action(fact, i);
    if (taken != null) {
      step(action, taken, instance(action.source()), report);
    }
  }

  /** Without a message whose interval is over, as if it had never been sent. */
  private static States without(String m, States s) {
    Area area = s.area().at(m);
    Fun<RobotId, Place> pos = s.pos();
    for (RobotId i : s.pos().arguments()) {
      pos = pos.with(i, s.pos().at(i).without(area));
    }
    return new States(
        s.now(),
        pos,
        Sets.remove(m, s.sent()),
        forgotten(m, s.t0()),
        forgotten(m, s.d()),
        forgotten(m, s.area()),
        forgotten(m, s.got()),
        forgotten(m, s.was_in()),
        forgotten(m, s.was_out()));
  }

  private static <V> Fun<String, V> forgotten(String m, Fun<String, V> of) {
    return of.with(m, of.defaultValue());
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

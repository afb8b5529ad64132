package org.starl.primitives.geocast;

import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The theory {@code Geocast_decls} as an executable automaton: messages to all robots in an area.
 * {@code PIDS} are robots, {@code Msgs} the ids of geocasts, times are in ns. An area is
 * represented by the id of its geocast, and a place, of {@code Places}, by the set of the areas
 * that contain it: {@code area(m)(p)} is {@code p.contains(area(m))}. {@link GeocastConformance}
 * replays runs on it.
 */
public final class GeocastAutomaton implements Automaton<GeocastAutomaton.States, GeocastAction> {

  /** The theory's name. */
  public static final String GEOCAST_DECLS = "Geocast_decls";

  private static final Fun<RobotId, Boolean> EMPTYSET = Fun.always(false);

  /**
   * The theory's states.
   *
   * @param now the time since the start
   * @param pos the place of a robot
   * @param sent whether a message was sent
   * @param t0 when it was sent
   * @param d the length of the interval in which robots in its area may receive it
   * @param area the area it is sent to
   * @param got the robots that received it, and have not restarted since
   * @param was_in the robots that were in the area during its interval
   * @param was_out the robots that were outside the area during its interval
   */
  public record States(
      long now,
      Fun<RobotId, SortedSet<String>> pos,
      Fun<String, Boolean> sent,
      Fun<String, Long> t0,
      Fun<String, Long> d,
      Fun<String, String> area,
      Fun<String, Fun<RobotId, Boolean>> got,
      Fun<String, Fun<RobotId, Boolean>> was_in,
      Fun<String, Fun<RobotId, Boolean>> was_out) {

    /** {@code open?(m, s)}. */
    boolean isOpen(String m) {
      return sent.at(m) && now <= t0.at(m) + d.at(m);
    }

    private boolean isIn(SortedSet<String> place, String m) {
      return place.contains(area.at(m));
    }

    private States withPos(RobotId i, SortedSet<String> place) {
      return new States(now, pos.with(i, place), sent, t0, d, area, got, was_in, was_out);
    }

    private States withGot(Fun<String, Fun<RobotId, Boolean>> newGot) {
      return new States(now, pos, sent, t0, d, area, newGot, was_in, was_out);
    }

    /** Removes a message whose interval is over, as if it had never been sent. */
    States without(String m) {
      Fun<RobotId, SortedSet<String>> places = pos;
      for (RobotId i : those(pos, m)) {
        places = places.with(i, Sets.remove(area.at(m), pos.at(i)));
      }
      return new States(
          now,
          places,
          sent.with(m, false),
          t0.with(m, t0.defaultValue()),
          d.with(m, d.defaultValue()),
          area.with(m, area.defaultValue()),
          got.with(m, EMPTYSET),
          was_in.with(m, EMPTYSET),
          was_out.with(m, EMPTYSET));
    }

    private SortedSet<RobotId> those(Fun<RobotId, SortedSet<String>> places, String m) {
      SortedSet<RobotId> inside = new TreeSet<>();
      places.forEach((i, place) -> {
        if (isIn(place, m)) {
          inside.add(i);
        }
      });
      return inside;
    }
  }

  @Override
  public String theory() {
    return GEOCAST_DECLS;
  }

  @Override
  public States start() {
    return new States(
        0,
        Fun.always(Sets.emptyset()),
        Fun.always(false),
        Fun.always(0L),
        Fun.always(0L),
        Fun.always(""),
        Fun.always(EMPTYSET),
        Fun.always(EMPTYSET),
        Fun.always(EMPTYSET));
  }

  @Override
  public Enabled enabled(GeocastAction action, States s) {
    return switch (action) {
      case GeocastAction.dt a -> Enabled.TRUE;
      case GeocastAction.do_geocast a ->
          Enabled.when("NOT sent(m)", !s.sent.at(a.m()), () -> "sent(" + a.m() + ")");
      case GeocastAction.deliver a ->
          Enabled.when("open?(m, s)", s.isOpen(a.m()), () -> whyNotOpen(a.m(), s))
              .and(
                  "was_in(m)(i)",
                  s.was_in.at(a.m()).at(a.i()),
                  () -> "was_in(" + a.m() + ") = " + s.was_in.at(a.m()))
              .and(
                  "NOT got(m)(i)",
                  !s.got.at(a.m()).at(a.i()),
                  () -> "got(" + a.m() + ") = " + s.got.at(a.m()));
      case GeocastAction.move a -> Enabled.TRUE;
      case GeocastAction.restart a -> Enabled.TRUE;
    };
  }

  private static String whyNotOpen(String m, States s) {
    return s.sent.at(m)
        ? "now = " + s.now + ", t0 = " + s.t0.at(m) + ", d = " + s.d.at(m)
        : m + " was never sent, or is over and forgotten";
  }

  @Override
  public States trans(GeocastAction action, States s) {
    return switch (action) {
      case GeocastAction.dt a ->
          new States(
              s.now + a.delta_t(), s.pos, s.sent, s.t0, s.d, s.area, s.got, s.was_in, s.was_out);
      case GeocastAction.do_geocast a -> sends(a, s);
      case GeocastAction.deliver a ->
          s.withGot(s.got.with(a.m(), s.got.at(a.m()).with(a.i(), true)));
      case GeocastAction.move a -> moves(a.i(), a.p(), s);
      case GeocastAction.restart a -> restarts(a.i(), s);
    };
  }

  private static States sends(GeocastAction.do_geocast a, States s) {
    String m = a.m();
    Fun<String, String> area = s.area.with(m, a.A());
    States named = new States(s.now, s.pos, s.sent, s.t0, s.d, area, s.got, s.was_in, s.was_out);
    Fun<RobotId, Boolean> inside = EMPTYSET;
    Fun<RobotId, Boolean> outside = Fun.always(true);
    for (RobotId i : named.those(s.pos, m)) {
      inside = inside.with(i, true);
      outside = outside.with(i, false);
    }
    return new States(
        s.now,
        s.pos,
        s.sent.with(m, true),
        s.t0.with(m, s.now),
        s.d.with(m, a.bound()),
        area,
        s.got.with(m, EMPTYSET),
        s.was_in.with(m, inside),
        s.was_out.with(m, outside));
  }

  private static States moves(RobotId i, SortedSet<String> place, States s) {
    States after = s.withPos(i, place);
    Fun<String, Fun<RobotId, Boolean>> in = s.was_in;
    Fun<String, Fun<RobotId, Boolean>> out = s.was_out;
    for (String m : sent(s)) {
      if (s.isOpen(m) && s.isIn(place, m)) {
        in = in.with(m, in.at(m).with(i, true));
      } else if (s.isOpen(m)) {
        out = out.with(m, out.at(m).with(i, true));
      }
    }
    return new States(after.now, after.pos, s.sent, s.t0, s.d, s.area, s.got, in, out);
  }

  private static States restarts(RobotId i, States s) {
    Fun<String, Fun<RobotId, Boolean>> got = s.got;
    for (String m : sent(s)) {
      got = got.with(m, got.at(m).with(i, false));
    }
    return s.withGot(got);
  }

  private static SortedSet<String> sent(States s) {
    SortedSet<String> sent = new TreeSet<>();
    s.sent.forEach((m, isSent) -> sent.add(m));
    return sent;
  }
}

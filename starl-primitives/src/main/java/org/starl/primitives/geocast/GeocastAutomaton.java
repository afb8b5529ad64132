// Generated from Geocast_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.geocast;

import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The automaton Geocast_decls, executable.
 *
 * <p>Geocast (paper, section 4.2), safety: a message to all in an area A, within an interval of
 * length d.
 *
 * <p>A message m is sent at t0(m), to area(m), until t0(m) + d(m). Whoever has been in the area in
 * that interval may be handed it, once, as long as the interval is not over; a process that
 * restarts has forgotten what it was handed. Places change at any time. was_in and was_out say, of
 * each message and process, whether the process has been inside or outside the area at some time of
 * the interval.
 *
 * <p>Nothing is assumed: messages may be lost, late and doubled, and time passes as it likes. What
 * is owed in time is in Geocast_progress. Java: org.starl.primitives.geocast.Geocast; this
 * automaton: GeocastAutomaton; monitors: GeocastSpec, GeocastConformance.
 */
public final class GeocastAutomaton implements Automaton<GeocastAutomaton.States, GeocastAction> {

  /** The theory's name. */
  public static final String GEOCAST_DECLS = "Geocast_decls";

  /** The states. */
  public record States(
      long now,
      Fun<RobotId, Place> pos,
      SortedSet<String> sent,
      Fun<String, Long> t0,
      Fun<String, Long> d,
      Fun<String, Area> area,
      Fun<String, Fun<RobotId, Boolean>> got,
      Fun<String, Fun<RobotId, Boolean>> was_in,
      Fun<String, Fun<RobotId, Boolean>> was_out) {

    public boolean isOpen(String m) {
      return sent.contains(m) && now <= t0.at(m) + d.at(m);
    }

    public boolean isOver(String m) {
      return sent.contains(m) && now > t0.at(m) + d.at(m);
    }

    private States with_now(long now) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_pos(Fun<RobotId, Place> pos) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_sent(SortedSet<String> sent) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_t0(Fun<String, Long> t0) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_d(Fun<String, Long> d) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_area(Fun<String, Area> area) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_got(Fun<String, Fun<RobotId, Boolean>> got) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_was_in(Fun<String, Fun<RobotId, Boolean>> was_in) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }

    private States with_was_out(Fun<String, Fun<RobotId, Boolean>> was_out) {
      return new States(now, pos, sent, t0, d, area, got, was_in, was_out);
    }
  }

  @Override
  public String theory() {
    return GEOCAST_DECLS;
  }

  @Override
  public States start() {
    return new States(
        0L,
        Fun.always(Place.ELSEWHERE),
        Sets.emptyset(),
        Fun.always(0L),
        Fun.always(0L),
        Fun.always(Area.NONE),
        Fun.always(Fun.always(false)),
        Fun.always(Fun.always(false)),
        Fun.always(Fun.always(false)));
  }

  @Override
  public Enabled enabled(GeocastAction action, States s) {
    return switch (action) {
      case GeocastAction.dt a -> Enabled.TRUE;
      case GeocastAction.do_geocast a ->
          Enabled.when("not m in sent", !s.sent.contains(a.m()), () -> "sent = " + s.sent);
      case GeocastAction.deliver a ->
          Enabled.when(
                  "open?(m)",
                  s.isOpen(a.m()),
                  () ->
                      !s.sent.contains(a.m())
                          ? "sent = " + s.sent
                          : String.format(
                              "now = %s, t0(%s) = %s, d(%s) = %s",
                              s.now, a.m(), s.t0.at(a.m()), a.m(), s.d.at(a.m())))
              .and(
                  "i in was_in(m)",
                  s.was_in.at(a.m()).at(a.i()),
                  () -> "was_in(" + a.m() + ") = " + s.was_in.at(a.m()))
              .and(
                  "not i in got(m)",
                  !s.got.at(a.m()).at(a.i()),
                  () -> "got(" + a.m() + ") = " + s.got.at(a.m()));
      case GeocastAction.move a -> Enabled.TRUE;
      case GeocastAction.restart a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(GeocastAction action, States s) {
    return switch (action) {
      case GeocastAction.dt a -> s.with_now(s.now + a.delta_t());
      case GeocastAction.do_geocast a ->
          s.with_sent(Sets.add(a.m(), s.sent))
              .with_t0(s.t0.with(a.m(), s.now))
              .with_d(s.d.with(a.m(), a.bound()))
              .with_area(s.area.with(a.m(), a.A()))
              .with_got(s.got.with(a.m(), Fun.always(false)))
              .with_was_in(
                  s.was_in.with(
                      a.m(),
                      Finite.map(
                          Fun.always(a.A().contains(s.pos.defaultValue())),
                          i -> a.A().contains(s.pos.at(i)),
                          s.pos.arguments())))
              .with_was_out(
                  s.was_out.with(
                      a.m(),
                      Finite.map(
                          Fun.always(!a.A().contains(s.pos.defaultValue())),
                          i -> !a.A().contains(s.pos.at(i)),
                          s.pos.arguments())));
      case GeocastAction.deliver a ->
          s.with_got(s.got.with(a.m(), s.got.at(a.m()).with(a.i(), true)));
      case GeocastAction.move a ->
          s.with_pos(s.pos.with(a.i(), a.p()))
              .with_was_in(
                  Finite.map(
                      s.was_in,
                      m ->
                          s.isOpen(m) && s.area.at(m).contains(a.p())
                              ? s.was_in.at(m).with(a.i(), true)
                              : s.was_in.at(m),
                      s.sent))
              .with_was_out(
                  Finite.map(
                      s.was_out,
                      m ->
                          s.isOpen(m) && !s.area.at(m).contains(a.p())
                              ? s.was_out.at(m).with(a.i(), true)
                              : s.was_out.at(m),
                      s.sent));
      case GeocastAction.restart a ->
          s.with_got(
              Finite.map(
                  Fun.always(s.got.defaultValue().with(a.i(), false)),
                  m -> s.got.at(m).with(a.i(), false),
                  s.got.arguments()));
    };
  }
}

// Generated from Traffic_decls.starl by 'starl compile': change that file instead.
// Longer than 500 lines because its source is one automaton.
package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.SortedSet;
import java.util.function.Function;
import org.starl.id.ProcessId;
import org.starl.primitives.mutex.MutexGroupAction;
import org.starl.primitives.mutex.MutexGroupAutomaton;
import org.starl.primitives.registration.RegistrationAction;
import org.starl.primitives.registration.RegistrationAutomaton;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Term;
import org.starl.spec.automaton.Undefined;

/**
 * The automaton Traffic_decls, executable.
 *
 * <p>The intersection coordination protocol (paper, Figures 3 to 6), run by every process of PIDS,
 * composed with Registration and with Mutex over the lists that Registration gives. Cars come at
 * any time, ask to be listed, ask those on their list for the zones of their way, cross them one by
 * one, give each back once they are past it, and leave the list when they hold nothing any more.
 *
 * <p>Parameters: Path, sd : the critical zones of each pair of source and destination, in order,
 * none twice; the pair of each process B : longest stay in S0, before do_register R : longest time
 * from do_register until the zones are requested G : if somebody waits and nobody holds a zone,
 * somebody is granted within G T : longest time to cross one zone and give it back
 *
 * <p>Where the figures say nothing, or what cannot be meant: - Positions: safety is of cars, not of
 * list heads. A zone is given back once the car is past it (`release'). - S1 is entered with the
 * release of the last zone. - A request asks those on the list of the requester only. That suffices
 * for safety, because lists leave out only who holds nothing (lemma `connects' of Traffic_safety,
 * from Keeps of Registration_decls). - `decide' happens only if it lets somebody in or out, `learn'
 * only of a newer list: so runs without time are short (Traffic_progress).
 *
 * <p>A process is one attempt of a car to take part: a car whose program restarts, or that others
 * have given up, begins anew as another process, and the earlier one gives up (`give_up'). What
 * this one held, the car's body may still stand in: it is kept (rest_set) until the car is taken
 * off the road (`towed'), or goes on as the next process (`restart'), says where its body is
 * (`stands_in'), asks for the zones from there on (`skip'), and is granted them. Bounds in time are
 * of runs in which no request is withdrawn, and no process gives up or begins anew (`calm').
 *
 * <p>What the primitives do of themselves (decide, learn, od_mutex) is enabled when they say so.
 * What they are asked to do is enabled when the protocol says so; that the primitives allow it is
 * proved: mux_step and reg_step of Traffic_safety.
 *
 * <p>Java: org.starl.apps.intersection.logic.IntersectionApp; monitors:
 * org.starl.apps.intersection.spec.
 */
public final class TrafficAutomaton implements Automaton<TrafficAutomaton.States, TrafficAction> {

  /** The theory's name. */
  public static final String TRAFFIC_DECLS = "Traffic_decls";

  private final MutexGroupAutomaton muxAutomaton = new MutexGroupAutomaton();
  private final RegistrationAutomaton regAutomaton = new RegistrationAutomaton();

  private final Function<String, List<String>> Path;
  private final Function<ProcessId, String> sd;
  private final long B;
  private final long R;
  private final long G;
  private final long T;

  /** Of the theory's parameters. */
  public TrafficAutomaton(
      Function<String, List<String>> Path,
      Function<ProcessId, String> sd,
      long B,
      long R,
      long G,
      long T) {
    this.Path = Path;
    this.sd = sd;
    this.B = B;
    this.R = R;
    this.G = G;
    this.T = T;
  }

  /** The theory's parameter. */
  public long B() {
    return B;
  }

  /** The theory's parameter. */
  public long R() {
    return R;
  }

  /** The theory's parameter. */
  public long G() {
    return G;
  }

  /** The theory's parameter. */
  public long T() {
    return T;
  }

  public enum Locations {
    away,
    S0,
    register_wait,
    mutex_wait,
    move_wait,
    S1,
    done,
    over
  }

  /** Where the car is: before, in or past the critical zones. */
  public sealed interface Position extends Term, Comparable<Position> {

    record arrival() implements Position {
      @Override
      public String toString() {
        return text();
      }
    }

    record inside(String zone) implements Position {
      @Override
      public String toString() {
        return text();
      }
    }

    record departed() implements Position {
      @Override
      public String toString() {
        return text();
      }
    }

    @Override
    default List<Object> args() {
      return switch (this) {
        case arrival a -> List.of();
        case inside a -> List.of(a.zone);
        case departed a -> List.of();
      };
    }

    @Override
    default int compareTo(Position that) {
      return Sets.compare(this, that);
    }
  }

  /**
   * The states.
   *
   * @param myseq the zones not given back yet
   * @param age since i came
   * @param timer_start in S0
   * @param timer_reg in register_wait
   * @param timer_move with the present zone
   * @param timer_grant of waiting while nobody holds a zone
   * @param resumed began where an earlier process of its car had zones
   * @param calm no request was withdrawn, no process gave up or began anew
   */
  public record States(
      Fun<ProcessId, Locations> loc,
      Fun<ProcessId, List<String>> myseq,
      Fun<ProcessId, Position> pos,
      Fun<ProcessId, Long> age,
      Fun<ProcessId, Long> timer_start,
      Fun<ProcessId, Long> timer_reg,
      Fun<ProcessId, Long> timer_move,
      long timer_grant,
      SortedSet<ProcessId> resumed,
      boolean calm,
      MutexGroupAutomaton.States mux,
      RegistrationAutomaton.States reg) {

    /** What i holds, and what earlier processes of its car held. */
    public SortedSet<String> holds(ProcessId i) {
      return Sets.union(mux.mux().crit_set().at(i), mux.mux().rest_set().at(i));
    }

    /** Somebody waits, and nobody holds anything. */
    public boolean isGrantable() {
      return (Finite.exists(i -> loc.at(i) == Locations.mutex_wait, loc.arguments())
              || loc.defaultValue() == Locations.mutex_wait)
          && Finite.forAll(
              j -> holds(j).isEmpty(),
              mux.mux().crit_set().arguments(),
              mux.mux().rest_set().arguments())
          && Sets.union(mux.mux().crit_set().defaultValue(), mux.mux().rest_set().defaultValue())
              .isEmpty();
    }

    /** The car is where its way begins: before it, in its first zone, or just past this. */
    public boolean isAtItsWay(ProcessId i) {
      return !myseq.at(i).isEmpty()
          && (pos.at(i).equals(new Position.arrival())
              || pos.at(i)
                  .equals(
                      new Position.inside(
                          Undefined.head("Traffic_decls.starl:101:40", myseq.at(i))))
              || pos.at(i).equals(next_pos(myseq.at(i))));
    }

    private States with_loc(Fun<ProcessId, Locations> loc) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_myseq(Fun<ProcessId, List<String>> myseq) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_pos(Fun<ProcessId, Position> pos) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_age(Fun<ProcessId, Long> age) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_timer_start(Fun<ProcessId, Long> timer_start) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_timer_reg(Fun<ProcessId, Long> timer_reg) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_timer_move(Fun<ProcessId, Long> timer_move) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_timer_grant(long timer_grant) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_resumed(SortedSet<ProcessId> resumed) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_calm(boolean calm) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_mux(MutexGroupAutomaton.States mux) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }

    private States with_reg(RegistrationAutomaton.States reg) {
      return new States(
          loc,
          myseq,
          pos,
          age,
          timer_start,
          timer_reg,
          timer_move,
          timer_grant,
          resumed,
          calm,
          mux,
          reg);
    }
  }

  @Override
  public String theory() {
    return TRAFFIC_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Locations.away),
        Fun.of(i -> Path.apply(sd.apply(i))),
        Fun.always(new Position.arrival()),
        Fun.always(0L),
        Fun.always(0L),
        Fun.always(0L),
        Fun.always(0L),
        0L,
        Sets.emptyset(),
        true,
        muxAutomaton.start(),
        regAutomaton.start());
  }

  public static List<String> rest(List<String> l) {
    return l.isEmpty() ? List.of() : Undefined.tail("Traffic_decls.starl:89:58", l);
  }

  /** The first zone of the way; departed if there is none. */
  public static Position first_pos(List<String> l) {
    return l.isEmpty()
        ? new Position.departed()
        : new Position.inside(Undefined.head("Traffic_decls.starl:92:76", l));
  }

  /** The zone after the one that the car is in; departed after the last. */
  public static Position next_pos(List<String> l) {
    return l.isEmpty() || Undefined.tail("Traffic_decls.starl:96:16", l).isEmpty()
        ? new Position.departed()
        : new Position.inside(
            Undefined.head(
                "Traffic_decls.starl:96:55", Undefined.tail("Traffic_decls.starl:96:60", l)));
  }

  @Override
  public Enabled enabled(TrafficAction action, States s) {
    return switch (action) {
      case TrafficAction.dt a ->
          Enabled.when(
                  "grantable? => timer_grant + delta_t <= G",
                  !s.isGrantable() || s.timer_grant + a.delta_t() <= G,
                  () -> "timer_grant = " + s.timer_grant + ", G = " + G)
              .and(
                  "forall i: PIDS :: (loc(i) = S0 => timer_start(i) + delta_t <= B) and (loc(i) = register_wait => timer_reg(i) + delta_t <= R) and (loc(i) = move_wait => timer_move(i) + delta_t <= T)",
                  Finite.forAll(
                          i ->
                              (s.loc.at(i) != Locations.S0
                                      || s.timer_start.at(i) + a.delta_t() <= B)
                                  && (s.loc.at(i) != Locations.register_wait
                                      || s.timer_reg.at(i) + a.delta_t() <= R)
                                  && (s.loc.at(i) != Locations.move_wait
                                      || s.timer_move.at(i) + a.delta_t() <= T),
                          s.loc.arguments(),
                          s.timer_start.arguments(),
                          s.timer_reg.arguments(),
                          s.timer_move.arguments())
                      && (s.loc.defaultValue() != Locations.S0
                          || s.timer_start.defaultValue() + a.delta_t() <= B)
                      && (s.loc.defaultValue() != Locations.register_wait
                          || s.timer_reg.defaultValue() + a.delta_t() <= R)
                      && (s.loc.defaultValue() != Locations.move_wait
                          || s.timer_move.defaultValue() + a.delta_t() <= T),
                  () ->
                      Finite.first(
                          i ->
                              !((s.loc.at(i) != Locations.S0
                                      || s.timer_start.at(i) + a.delta_t() <= B)
                                  && (s.loc.at(i) != Locations.register_wait
                                      || s.timer_reg.at(i) + a.delta_t() <= R)
                                  && (s.loc.at(i) != Locations.move_wait
                                      || s.timer_move.at(i) + a.delta_t() <= T)),
                          i ->
                              "i = "
                                  + i
                                  + ", "
                                  + (!((s.loc.at(i) != Locations.S0
                                              || s.timer_start.at(i) + a.delta_t() <= B)
                                          && (s.loc.at(i) != Locations.register_wait
                                              || s.timer_reg.at(i) + a.delta_t() <= R))
                                      ? (!(s.loc.at(i) != Locations.S0
                                              || s.timer_start.at(i) + a.delta_t() <= B)
                                          ? String.format(
                                              "loc(%s) = %s, timer_start(%s) = %s, B = %s",
                                              i, s.loc.at(i), i, s.timer_start.at(i), B)
                                          : String.format(
                                              "loc(%s) = %s, timer_reg(%s) = %s, R = %s",
                                              i, s.loc.at(i), i, s.timer_reg.at(i), R))
                                      : String.format(
                                          "loc(%s) = %s, timer_move(%s) = %s, T = %s",
                                          i, s.loc.at(i), i, s.timer_move.at(i), T)),
                          s.loc.arguments(),
                          s.timer_start.arguments(),
                          s.timer_reg.arguments(),
                          s.timer_move.arguments()));
      case TrafficAction.arrive a ->
          Enabled.when(
              "loc(i) = away",
              s.loc.at(a.i()) == Locations.away,
              () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()));
      case TrafficAction.do_register a ->
          Enabled.when(
              "loc(i) = S0",
              s.loc.at(a.i()) == Locations.S0,
              () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()));
      case TrafficAction.decide a ->
          Enabled.when(
                  "reg.decide(L)",
                  regAutomaton.enabled(new RegistrationAction.decide(a.L()), s.reg))
              .and(
                  "L != reg.list(reg.number)",
                  !a.L().equals(s.reg.list().at(s.reg.number())),
                  () -> "reg.list(" + s.reg.number() + ") = " + s.reg.list().at(s.reg.number()));
      case TrafficAction.learn a ->
          Enabled.when(
                  "reg.learn(i, n)",
                  regAutomaton.enabled(new RegistrationAction.learn(a.i(), a.n()), s.reg))
              .and(
                  "reg.ts(i) < n",
                  s.reg.ts().at(a.i()) < a.n(),
                  () -> "reg.ts(" + a.i() + ") = " + s.reg.ts().at(a.i()));
      case TrafficAction.do_mutex a ->
          Enabled.when(
                  "loc(i) = register_wait",
                  s.loc.at(a.i()) == Locations.register_wait,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "i in reg.rList(i)",
                  s.reg.rList(a.i()).contains(a.i()),
                  () -> "rList(" + a.i() + ") = " + s.reg.rList(a.i()))
              .and(
                  "RS = elements(myseq(i))",
                  a.RS().equals(Sets.of(s.myseq.at(a.i()))),
                  () -> "myseq(" + a.i() + ") = " + s.myseq.at(a.i()))
              .and(
                  "at_its_way?(i)",
                  () -> s.isAtItsWay(a.i()),
                  () ->
                      s.myseq.at(a.i()).isEmpty()
                          ? "myseq(" + a.i() + ") = " + s.myseq.at(a.i())
                          : String.format(
                              "pos(%s) = %s, myseq(%s) = %s, next_pos(%s) = %s",
                              a.i(),
                              s.pos.at(a.i()),
                              a.i(),
                              s.myseq.at(a.i()),
                              s.myseq.at(a.i()),
                              next_pos(s.myseq.at(a.i()))));
      case TrafficAction.od_mutex a ->
          Enabled.when(
                  "loc(i) = mutex_wait",
                  s.loc.at(a.i()) == Locations.mutex_wait,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "mux.od_mutex(i, RS)",
                  muxAutomaton.enabled(new MutexGroupAction.od_mutex(a.i(), a.RS()), s.mux));
      case TrafficAction.advance a ->
          Enabled.when(
                  "loc(i) = move_wait",
                  s.loc.at(a.i()) == Locations.move_wait,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "myseq(i) != []",
                  !s.myseq.at(a.i()).isEmpty(),
                  () -> "myseq(" + a.i() + ") = " + s.myseq.at(a.i()))
              .and(
                  "pos(i) = arrival or pos(i) = inside(head(myseq(i)))",
                  () ->
                      s.pos.at(a.i()).equals(new Position.arrival())
                          || s.pos
                              .at(a.i())
                              .equals(
                                  new Position.inside(
                                      Undefined.head(
                                          "Traffic_decls.starl:142:79", s.myseq.at(a.i())))),
                  () ->
                      String.format(
                          "pos(%s) = %s, myseq(%s) = %s",
                          a.i(), s.pos.at(a.i()), a.i(), s.myseq.at(a.i())));
      case TrafficAction.release a ->
          Enabled.when(
                  "loc(i) = move_wait",
                  s.loc.at(a.i()) == Locations.move_wait,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "myseq(i) != []",
                  !s.myseq.at(a.i()).isEmpty(),
                  () -> "myseq(" + a.i() + ") = " + s.myseq.at(a.i()))
              .and(
                  "RS = {head(myseq(i))}",
                  () ->
                      a.RS()
                          .equals(
                              Sets.singleton(
                                  Undefined.head("Traffic_decls.starl:146:49", s.myseq.at(a.i())))),
                  () -> "myseq(" + a.i() + ") = " + s.myseq.at(a.i()))
              .and(
                  "pos(i) = next_pos(myseq(i))",
                  () -> s.pos.at(a.i()).equals(next_pos(s.myseq.at(a.i()))),
                  () ->
                      String.format(
                          "pos(%s) = %s, next_pos(%s) = %s",
                          a.i(), s.pos.at(a.i()), s.myseq.at(a.i()), next_pos(s.myseq.at(a.i()))));
      case TrafficAction.unregister a ->
          Enabled.when(
              "loc(i) = S1",
              s.loc.at(a.i()) == Locations.S1,
              () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()));
      case TrafficAction.withdraw a ->
          Enabled.when(
              "loc(i) = mutex_wait",
              s.loc.at(a.i()) == Locations.mutex_wait,
              () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()));
      case TrafficAction.give_up a ->
          Enabled.when(
              "loc(i) = register_wait or loc(i) = mutex_wait or loc(i) = move_wait",
              s.loc.at(a.i()) == Locations.register_wait
                  || s.loc.at(a.i()) == Locations.mutex_wait
                  || s.loc.at(a.i()) == Locations.move_wait,
              () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()));
      case TrafficAction.towed a ->
          Enabled.when(
                  "loc(i) = over",
                  s.loc.at(a.i()) == Locations.over,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "pos(i) != departed",
                  !s.pos.at(a.i()).equals(new Position.departed()),
                  () -> "pos(" + a.i() + ") = " + s.pos.at(a.i()));
      case TrafficAction.restart a ->
          Enabled.when(
                  "loc(i) = away",
                  s.loc.at(a.i()) == Locations.away,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "loc(j) = over or loc(j) = S1 or loc(j) = done",
                  s.loc.at(a.j()) == Locations.over
                      || s.loc.at(a.j()) == Locations.S1
                      || s.loc.at(a.j()) == Locations.done,
                  () -> "loc(" + a.j() + ") = " + s.loc.at(a.j()))
              .and(
                  "sd(i) = sd(j)",
                  sd.apply(a.i()).equals(sd.apply(a.j())),
                  () -> "i = " + a.i() + ", j = " + a.j());
      case TrafficAction.stands_in a ->
          Enabled.when(
              "pos(i) is inside => pos(i).zone in RS or pos(i).zone in mux.mux.crit_set(i)",
              !(s.pos.at(a.i()) instanceof Position.inside)
                  || a.RS()
                      .contains(
                          Undefined.form(
                                  "Traffic_decls.starl:173:27",
                                  "zone",
                                  Position.inside.class,
                                  s.pos.at(a.i()))
                              .zone())
                  || s.mux
                      .mux()
                      .crit_set()
                      .at(a.i())
                      .contains(
                          Undefined.form(
                                  "Traffic_decls.starl:173:48",
                                  "zone",
                                  Position.inside.class,
                                  s.pos.at(a.i()))
                              .zone()),
              () ->
                  String.format(
                      "pos(%s) = %s, pos(%s).zone = %s, mux.mux.crit_set(%s) = %s",
                      a.i(),
                      s.pos.at(a.i()),
                      a.i(),
                      ((Position.inside) s.pos.at(a.i())).zone(),
                      a.i(),
                      s.mux.mux().crit_set().at(a.i())));
      case TrafficAction.skip a ->
          Enabled.when(
                  "loc(i) = register_wait",
                  s.loc.at(a.i()) == Locations.register_wait,
                  () -> "loc(" + a.i() + ") = " + s.loc.at(a.i()))
              .and(
                  "myseq(i) != []",
                  !s.myseq.at(a.i()).isEmpty(),
                  () -> "myseq(" + a.i() + ") = " + s.myseq.at(a.i()))
              .and(
                  "tail(myseq(i)) != []",
                  () -> !Undefined.tail("Traffic_decls.starl:177:47", s.myseq.at(a.i())).isEmpty(),
                  () -> "myseq(" + a.i() + ") = " + s.myseq.at(a.i()))
              .and(
                  "pos(i) != arrival",
                  !s.pos.at(a.i()).equals(new Position.arrival()),
                  () -> "pos(" + a.i() + ") = " + s.pos.at(a.i()));
    };
  }

  @Override
  public States trans(TrafficAction action, States s) {
    return switch (action) {
      case TrafficAction.dt a ->
          s.with_age(
                  Finite.map(
                      Fun.always(
                          s.loc.defaultValue() == Locations.away
                              ? s.age.defaultValue()
                              : s.age.defaultValue() + a.delta_t()),
                      i -> s.loc.at(i) == Locations.away ? s.age.at(i) : s.age.at(i) + a.delta_t(),
                      s.loc.arguments(),
                      s.age.arguments()))
              .with_timer_start(
                  Finite.map(
                      Fun.always(
                          s.loc.defaultValue() == Locations.S0
                              ? s.timer_start.defaultValue() + a.delta_t()
                              : s.timer_start.defaultValue()),
                      i ->
                          s.loc.at(i) == Locations.S0
                              ? s.timer_start.at(i) + a.delta_t()
                              : s.timer_start.at(i),
                      s.loc.arguments(),
                      s.timer_start.arguments()))
              .with_timer_reg(
                  Finite.map(
                      Fun.always(
                          s.loc.defaultValue() == Locations.register_wait
                              ? s.timer_reg.defaultValue() + a.delta_t()
                              : s.timer_reg.defaultValue()),
                      i ->
                          s.loc.at(i) == Locations.register_wait
                              ? s.timer_reg.at(i) + a.delta_t()
                              : s.timer_reg.at(i),
                      s.loc.arguments(),
                      s.timer_reg.arguments()))
              .with_timer_move(
                  Finite.map(
                      Fun.always(
                          s.loc.defaultValue() == Locations.move_wait
                              ? s.timer_move.defaultValue() + a.delta_t()
                              : s.timer_move.defaultValue()),
                      i ->
                          s.loc.at(i) == Locations.move_wait
                              ? s.timer_move.at(i) + a.delta_t()
                              : s.timer_move.at(i),
                      s.loc.arguments(),
                      s.timer_move.arguments()))
              .with_timer_grant(s.isGrantable() ? s.timer_grant + a.delta_t() : s.timer_grant);
      case TrafficAction.arrive a -> s.with_loc(s.loc.with(a.i(), Locations.S0));
      case TrafficAction.do_register a ->
          enabled(action, s).isTrue()
              ? s.with_loc(s.loc.with(a.i(), Locations.register_wait))
                  .with_reg(
                      Undefined.step(
                          "Traffic_decls.starl:123:32",
                          "reg",
                          regAutomaton,
                          new RegistrationAction.do_register(a.i()),
                          s.reg))
              : s;
      case TrafficAction.decide a ->
          enabled(action, s).isTrue()
              ? s.with_reg(
                  Undefined.step(
                      "Traffic_decls.starl:127:7",
                      "reg",
                      regAutomaton,
                      new RegistrationAction.decide(a.L()),
                      s.reg))
              : s;
      case TrafficAction.learn a ->
          enabled(action, s).isTrue()
              ? s.with_mux(
                      s.loc.at(a.i()) == Locations.mutex_wait
                          ? Undefined.step(
                              "Traffic_decls.starl:131:24",
                              "mux",
                              muxAutomaton,
                              new MutexGroupAction.known(a.i(), s.reg.list().at(a.n())),
                              s.mux)
                          : s.mux)
                  .with_reg(
                      Undefined.step(
                          "Traffic_decls.starl:131:7",
                          "reg",
                          regAutomaton,
                          new RegistrationAction.learn(a.i(), a.n()),
                          s.reg))
              : s;
      case TrafficAction.do_mutex a ->
          enabled(action, s).isTrue()
              ? s.with_loc(s.loc.with(a.i(), Locations.mutex_wait))
                  .with_mux(
                      Undefined.step(
                          "Traffic_decls.starl:135:29",
                          "mux",
                          muxAutomaton,
                          new MutexGroupAction.do_mutex(a.i(), a.RS(), s.reg.rList(a.i())),
                          s.mux))
              : s;
      case TrafficAction.od_mutex a ->
          enabled(action, s).isTrue()
              ? s.with_loc(s.loc.with(a.i(), Locations.move_wait))
                  .with_timer_move(s.timer_move.with(a.i(), 0L))
                  .with_timer_grant(0L)
                  .with_mux(
                      Undefined.step(
                          "Traffic_decls.starl:139:66",
                          "mux",
                          muxAutomaton,
                          new MutexGroupAction.od_mutex(a.i(), a.RS()),
                          s.mux))
              : s;
      case TrafficAction.advance a ->
          enabled(action, s).isTrue()
              ? s.with_pos(
                  s.pos.with(
                      a.i(),
                      s.pos.at(a.i()).equals(new Position.arrival())
                          ? first_pos(s.myseq.at(a.i()))
                          : next_pos(s.myseq.at(a.i()))))
              : s;
      case TrafficAction.release a ->
          enabled(action, s).isTrue()
              ? s.with_loc(
                      s.loc.with(
                          a.i(),
                          rest(s.myseq.at(a.i())).isEmpty() ? Locations.S1 : Locations.move_wait))
                  .with_myseq(s.myseq.with(a.i(), rest(s.myseq.at(a.i()))))
                  .with_timer_move(s.timer_move.with(a.i(), 0L))
                  .with_mux(
                      Undefined.step(
                          "Traffic_decls.starl:149:7",
                          "mux",
                          muxAutomaton,
                          new MutexGroupAction.release(a.i(), a.RS()),
                          s.mux))
              : s;
      case TrafficAction.unregister a ->
          enabled(action, s).isTrue()
              ? s.with_loc(s.loc.with(a.i(), Locations.done))
                  .with_reg(
                      Undefined.step(
                          "Traffic_decls.starl:153:23",
                          "reg",
                          regAutomaton,
                          new RegistrationAction.unregister(a.i()),
                          s.reg))
              : s;
      case TrafficAction.withdraw a ->
          enabled(action, s).isTrue()
              ? s.with_loc(s.loc.with(a.i(), Locations.register_wait))
                  .with_calm(false)
                  .with_mux(
                      Undefined.step(
                          "Traffic_decls.starl:157:32",
                          "mux",
                          muxAutomaton,
                          new MutexGroupAction.withdraw(a.i()),
                          s.mux))
              : s;
      case TrafficAction.give_up a ->
          enabled(action, s).isTrue()
              ? s.with_loc(s.loc.with(a.i(), Locations.over))
                  .with_calm(false)
                  .with_mux(
                      Undefined.step(
                          "Traffic_decls.starl:161:39",
                          "mux",
                          muxAutomaton,
                          new MutexGroupAction.restart(a.i()),
                          s.mux))
                  .with_reg(
                      Undefined.step(
                          "Traffic_decls.starl:161:23",
                          "reg",
                          regAutomaton,
                          new RegistrationAction.give_up(a.i()),
                          s.reg))
              : s;
      case TrafficAction.towed a -> s.with_pos(s.pos.with(a.i(), new Position.departed()));
      case TrafficAction.restart a ->
          enabled(action, s).isTrue()
              ? Undefined.once(
                  "Traffic_decls.starl:169:39",
                  a.i().equals(a.j())
                      && !s.pos.at(a.j()).equals(new Position.departed())
                      && enabled(action, s).isTrue(),
                  "restart",
                  s.with_loc(s.loc.with(a.i(), Locations.S0))
                      .with_pos(
                          s.pos.with(a.i(), s.pos.at(a.j())).with(a.j(), new Position.departed()))
                      .with_resumed(Sets.add(a.i(), s.resumed))
                      .with_calm(false)
                      .with_mux(
                          Undefined.step(
                              "Traffic_decls.starl:170:7",
                              "mux",
                              muxAutomaton,
                              new MutexGroupAction.take_over(a.i(), a.j()),
                              s.mux)))
              : s;
      case TrafficAction.stands_in a ->
          enabled(action, s).isTrue()
              ? s.with_calm(false)
                  .with_mux(
                      Undefined.step(
                          "Traffic_decls.starl:174:7",
                          "mux",
                          muxAutomaton,
                          new MutexGroupAction.stands_in(a.i(), a.RS()),
                          s.mux))
              : s;
      case TrafficAction.skip a ->
          enabled(action, s).isTrue()
              ? s.with_myseq(s.myseq.with(a.i(), rest(s.myseq.at(a.i()))))
              : s;
    };
  }
}

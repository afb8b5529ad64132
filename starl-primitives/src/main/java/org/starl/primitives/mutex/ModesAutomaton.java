// Generated from Modes_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import java.util.function.BiPredicate;
import java.util.function.Function;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The automaton Modes_decls, executable.
 *
 * <p>Group mutual exclusion (Joung 1998): the abstract specification, with any number of processes.
 *
 * <p>A zone here is a section in a mode, such as a lane in one direction. Processes are in it
 * together, of any number or of at most so many; zones that exclude each other, such as the two
 * directions of a lane, have processes at different times. A process asks for a set of zones, is
 * granted them one by one or all at once, and gives them back. In which order is left open:
 * Pipeline_decls has an order. Of a zone with a limit each process in it has a place of its own.
 *
 * <p>A program may begin anew after a crash: what it held then, its body may still stand in, until
 * the program says where its body is. What is asked of the caller (do_mutex and stands_in with
 * sense, release of what is held) stands in the enabling conditions.
 *
 * <p>Java: org.starl.primitives.mutex.MutexPrim; this automaton: ModesAutomaton; monitors:
 * MutexSpec, ModesConformance.
 */
public final class ModesAutomaton implements Automaton<ModesAutomaton.States, ModesAction> {

  /** The theory's name. */
  public static final String MODES_DECLS = "Modes_decls";

  private final BiPredicate<String, String> excludes;
  private final Function<String, Long> most;

  /** Of the theory's parameters. */
  public ModesAutomaton(BiPredicate<String, String> excludes, Function<String, Long> most) {
    this.excludes = excludes;
    this.most = most;
  }

  /**
   * The states.
   *
   * @param crit_set held by the present program
   * @param req_set asked for and not yet granted
   * @param rest_set held by earlier starts of i's program
   * @param place i's one in a zone with a limit
   */
  public record States(
      Fun<RobotId, SortedSet<String>> crit_set,
      Fun<RobotId, SortedSet<String>> req_set,
      Fun<RobotId, SortedSet<String>> rest_set,
      Fun<RobotId, Fun<String, Long>> place) {

    public SortedSet<String> held(RobotId i) {
      return Sets.union(crit_set.at(i), rest_set.at(i));
    }
  }

  @Override
  public String theory() {
    return MODES_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Sets.emptyset()),
        Fun.always(Sets.emptyset()),
        Fun.always(Sets.emptyset()),
        Fun.always(Fun.always(0L)));
  }

  /** At most so many processes are in z; 0 is any number. */
  public boolean isLimited(String z) {
    return most.apply(z) > 0;
  }

  public boolean isApart(String y, String z) {
    return excludes.test(y, z) || excludes.test(z, y);
  }

  /** Nobody else holds what excludes z, or has place n of it. */
  public boolean isFreeFor(RobotId i, String z, long n, States s) {
    return Finite.forAll(
            j ->
                i.equals(j)
                    || (Finite.forAll(y -> !s.held(j).contains(y) || !isApart(y, z), s.held(j))
                        && (!(s.held(j).contains(z) && isLimited(z)) || s.place.at(j).at(z) != n)),
            List.of(i),
            s.crit_set.arguments(),
            s.rest_set.arguments(),
            s.place.arguments())
        && Finite.forAll(
            y ->
                !Sets.union(s.crit_set.defaultValue(), s.rest_set.defaultValue()).contains(y)
                    || !isApart(y, z),
            Sets.union(s.crit_set.defaultValue(), s.rest_set.defaultValue()))
        && (!(Sets.union(s.crit_set.defaultValue(), s.rest_set.defaultValue()).contains(z)
                && isLimited(z))
            || s.place.defaultValue().at(z) != n);
  }

  @Override
  public Enabled enabled(ModesAction action, States s) {
    return switch (action) {
      case ModesAction.do_mutex a ->
          Enabled.when("RS != {}", !a.RS().isEmpty(), () -> "RS = " + a.RS())
              .and(
                  "req_set(i) = {}",
                  s.req_set.at(a.i()).isEmpty(),
                  () -> "req_set(" + a.i() + ") = " + s.req_set.at(a.i()))
              .and(
                  "crit_set(i) = {}",
                  s.crit_set.at(a.i()).isEmpty(),
                  () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()));
      case ModesAction.grant a ->
          Enabled.when(
                  "z in req_set(i)",
                  s.req_set.at(a.i()).contains(a.z()),
                  () -> "req_set(" + a.i() + ") = " + s.req_set.at(a.i()))
              .and(
                  "free_for?(i, z, n)",
                  isFreeFor(a.i(), a.z(), a.n(), s),
                  () ->
                      Finite.first(
                          j ->
                              !(a.i().equals(j)
                                  || (Finite.forAll(
                                          y -> !s.held(j).contains(y) || !isApart(y, a.z()),
                                          s.held(j))
                                      && (!(s.held(j).contains(a.z()) && isLimited(a.z()))
                                          || s.place.at(j).at(a.z()) != a.n()))),
                          j ->
                              "j = "
                                  + j
                                  + ", "
                                  + (!Finite.forAll(
                                          y -> !s.held(j).contains(y) || !isApart(y, a.z()),
                                          s.held(j))
                                      ? Finite.first(
                                          y -> !(!s.held(j).contains(y) || !isApart(y, a.z())),
                                          y ->
                                              String.format(
                                                  "y = %s, held(%s) = %s", y, j, s.held(j)),
                                          s.held(j))
                                      : String.format(
                                          "held(%s) = %s, place(%s, %s) = %s",
                                          j, s.held(j), j, a.z(), s.place.at(j).at(a.z()))),
                          List.of(a.i()),
                          s.crit_set.arguments(),
                          s.rest_set.arguments(),
                          s.place.arguments()))
              .and(
                  "limited?(z) => n < most(z)",
                  !isLimited(a.z()) || a.n() < most.apply(a.z()),
                  () -> "z = " + a.z() + ", n = " + a.n());
      case ModesAction.release a ->
          Enabled.when(
              "RS subset crit_set(i)",
              s.crit_set.at(a.i()).containsAll(a.RS()),
              () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()));
      case ModesAction.withdraw a ->
          Enabled.when(
              "req_set(i) != {}",
              !s.req_set.at(a.i()).isEmpty(),
              () -> "req_set(" + a.i() + ") = " + s.req_set.at(a.i()));
      case ModesAction.restart a -> Enabled.TRUE;
      case ModesAction.stands_in a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(ModesAction action, States s) {
    return switch (action) {
      case ModesAction.do_mutex a ->
          new States(s.crit_set, s.req_set.with(a.i(), a.RS()), s.rest_set, s.place);
      case ModesAction.grant a ->
          new States(
              s.crit_set.with(a.i(), Sets.add(a.z(), s.crit_set.at(a.i()))),
              s.req_set.with(a.i(), Sets.remove(a.z(), s.req_set.at(a.i()))),
              s.rest_set,
              s.place.with(a.i(), s.place.at(a.i()).with(a.z(), a.n())));
      case ModesAction.release a ->
          new States(
              s.crit_set.with(a.i(), Sets.difference(s.crit_set.at(a.i()), a.RS())),
              s.req_set,
              s.rest_set,
              s.place);
      case ModesAction.withdraw a ->
          new States(s.crit_set, s.req_set.with(a.i(), Sets.emptyset()), s.rest_set, s.place);
      case ModesAction.restart a ->
          new States(
              s.crit_set.with(a.i(), Sets.emptyset()),
              s.req_set.with(a.i(), Sets.emptyset()),
              s.rest_set.with(a.i(), s.held(a.i())),
              s.place);
      case ModesAction.stands_in a ->
          new States(
              s.crit_set,
              s.req_set,
              s.rest_set.with(a.i(), Sets.intersection(s.rest_set.at(a.i()), a.RS())),
              s.place);
    };
  }
}

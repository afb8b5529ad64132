// Generated from Mutex_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Undefined;

/**
 * The automaton Mutex_decls, executable.
 *
 * <p>Mutual exclusion on sets of zones (paper, section 4.5): the abstract specification, with any
 * number of processes.
 *
 * <p>A process asks for a set of zones, is granted the whole set at once, and gives zones back one
 * by one or together. In which order requests are granted is left open. A program may begin anew
 * after a crash, also as another process: what it held then, its body may still stand in, until the
 * program says where its body is. What is asked of the caller (do_mutex and stands_in with sense,
 * release of what is held) stands in the enabling conditions.
 *
 * <p>Java: org.starl.primitives.mutex.MutexPrim; this automaton: MutexAutomaton; monitors:
 * MutexSpec, MutexConformance.
 */
public final class MutexAutomaton implements Automaton<MutexAutomaton.States, MutexAction> {

  /** The theory's name. */
  public static final String MUTEX_DECLS = "Mutex_decls";

  /**
   * The states.
   *
   * @param crit_set held by the present program
   * @param req_set asked for and not yet granted
   * @param rest_set held by earlier starts of i's program
   */
  public record States(
      Fun<ProcessId, SortedSet<String>> crit_set,
      Fun<ProcessId, SortedSet<String>> req_set,
      Fun<ProcessId, SortedSet<String>> rest_set) {

    public SortedSet<String> held(ProcessId i) {
      return Sets.union(crit_set.at(i), rest_set.at(i));
    }

    /** Nobody else holds a zone of RS. */
    public boolean isFreeFor(ProcessId i, SortedSet<String> RS) {
      return Finite.forAll(
              j -> i.equals(j) || Sets.disjoint(RS, held(j)),
              List.of(i),
              crit_set.arguments(),
              rest_set.arguments())
          && Sets.disjoint(RS, Sets.union(crit_set.defaultValue(), rest_set.defaultValue()));
    }
  }

  @Override
  public String theory() {
    return MUTEX_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Sets.emptyset()), Fun.always(Sets.emptyset()), Fun.always(Sets.emptyset()));
  }

  @Override
  public Enabled enabled(MutexAction action, States s) {
    return switch (action) {
      case MutexAction.do_mutex a ->
          Enabled.when("RS != {}", !a.RS().isEmpty(), () -> "RS = " + a.RS())
              .and(
                  "req_set(i) = {}",
                  s.req_set.at(a.i()).isEmpty(),
                  () -> "req_set(" + a.i() + ") = " + s.req_set.at(a.i()))
              .and(
                  "crit_set(i) = {}",
                  s.crit_set.at(a.i()).isEmpty(),
                  () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()));
      case MutexAction.od_mutex a ->
          Enabled.when("RS != {}", !a.RS().isEmpty(), () -> "RS = " + a.RS())
              .and(
                  "RS = req_set(i)",
                  a.RS().equals(s.req_set.at(a.i())),
                  () -> "req_set(" + a.i() + ") = " + s.req_set.at(a.i()))
              .and(
                  "free_for?(i, RS)",
                  s.isFreeFor(a.i(), a.RS()),
                  () ->
                      Finite.first(
                          j -> !(a.i().equals(j) || Sets.disjoint(a.RS(), s.held(j))),
                          j -> "held(" + j + ") = " + s.held(j),
                          List.of(a.i()),
                          s.crit_set.arguments(),
                          s.rest_set.arguments()));
      case MutexAction.release a ->
          Enabled.when(
              "RS subset crit_set(i)",
              s.crit_set.at(a.i()).containsAll(a.RS()),
              () -> "crit_set(" + a.i() + ") = " + s.crit_set.at(a.i()));
      case MutexAction.withdraw a ->
          Enabled.when(
              "req_set(i) != {}",
              !s.req_set.at(a.i()).isEmpty(),
              () -> "req_set(" + a.i() + ") = " + s.req_set.at(a.i()));
      case MutexAction.restart a -> Enabled.TRUE;
      case MutexAction.take_over a ->
          Enabled.when("not i = j", !a.i().equals(a.j()), () -> "i = " + a.i() + ", j = " + a.j());
      case MutexAction.stands_in a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(MutexAction action, States s) {
    return switch (action) {
      case MutexAction.do_mutex a ->
          new States(s.crit_set, s.req_set.with(a.i(), a.RS()), s.rest_set);
      case MutexAction.od_mutex a ->
          new States(
              s.crit_set.with(a.i(), a.RS()), s.req_set.with(a.i(), Sets.emptyset()), s.rest_set);
      case MutexAction.release a ->
          new States(
              s.crit_set.with(a.i(), Sets.difference(s.crit_set.at(a.i()), a.RS())),
              s.req_set,
              s.rest_set);
      case MutexAction.withdraw a ->
          new States(s.crit_set, s.req_set.with(a.i(), Sets.emptyset()), s.rest_set);
      case MutexAction.restart a ->
          new States(
              s.crit_set.with(a.i(), Sets.emptyset()),
              s.req_set.with(a.i(), Sets.emptyset()),
              s.rest_set.with(a.i(), s.held(a.i())));
      case MutexAction.take_over a ->
          Undefined.once(
              "Mutex_decls.starl:55:68",
              a.i().equals(a.j())
                  && !Sets.union(s.rest_set.at(a.i()), s.held(a.j())).isEmpty()
                  && enabled(action, s).isTrue(),
              "take_over",
              new States(
                  s.crit_set.with(a.j(), Sets.emptyset()),
                  s.req_set,
                  s.rest_set
                      .with(a.i(), Sets.union(s.rest_set.at(a.i()), s.held(a.j())))
                      .with(a.j(), Sets.emptyset())));
      case MutexAction.stands_in a ->
          new States(
              s.crit_set,
              s.req_set,
              s.rest_set.with(a.i(), Sets.intersection(s.rest_set.at(a.i()), a.RS())));
    };
  }
}

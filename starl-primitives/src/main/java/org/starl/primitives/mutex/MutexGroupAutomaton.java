// Generated from Mutex_group_decls.starl by 'starl compile': change that file instead.
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
 * The automaton Mutex_group_decls, executable.
 *
 * <p>The mutex as it is used (paper, section 4.5: do_mutex with a list of participants), above
 * Mutex_decls: a request is granted once those hold nothing of it who are on its list, or on whose
 * list it is; and nothing of it is left of what a process held that began anew, or was given up.
 * Such a process may be on no list any more: everybody knows what is left of it.
 *
 * <p>Assumed of the caller (connects?): of everybody who holds or waits for something he has on his
 * list whoever does not have him on theirs. It is what lists of a registration give that never
 * leave out a member who has not unregistered (Registration_decls, Keeps).
 *
 * <p>Java: org.starl.primitives.mutex.MutexProtocol, `known'; monitor: MutexSpec, Connected.
 */
public final class MutexGroupAutomaton
    implements Automaton<MutexGroupAutomaton.States, MutexGroupAction> {

  /** The theory's name. */
  public static final String MUTEX_GROUP_DECLS = "Mutex_group_decls";

  private final MutexAutomaton muxAutomaton = new MutexAutomaton();

  /** The states. */
  public record States(Fun<ProcessId, SortedSet<ProcessId>> plist, MutexAutomaton.States mux) {

    /** i holds or waits for something, by its present program. */
    public boolean isActive(ProcessId i) {
      return !mux.crit_set().at(i).isEmpty() || !mux.req_set().at(i).isEmpty();
    }

    public boolean isPeer(ProcessId i, ProcessId j) {
      return plist.at(i).contains(j) || plist.at(j).contains(i);
    }

    /** What is asked of the caller. */
    public boolean isConnects(ProcessId i, SortedSet<ProcessId> P) {
      return Finite.forAll(
              j -> !(!i.equals(j) && isActive(j)) || P.contains(j) || plist.at(j).contains(i),
              List.of(i),
              mux.crit_set().arguments(),
              mux.req_set().arguments(),
              P,
              plist.arguments())
          && (!(!mux.crit_set().defaultValue().isEmpty() || !mux.req_set().defaultValue().isEmpty())
              || plist.defaultValue().contains(i));
    }
  }

  @Override
  public String theory() {
    return MUTEX_GROUP_DECLS;
  }

  @Override
  public States start() {
    return new States(Fun.always(Sets.emptyset()), muxAutomaton.start());
  }

  @Override
  public Enabled enabled(MutexGroupAction action, States s) {
    return switch (action) {
      case MutexGroupAction.do_mutex a ->
          Enabled.when(
                  "mux.do_mutex(i, RS)",
                  muxAutomaton.enabled(new MutexAction.do_mutex(a.i(), a.RS()), s.mux))
              .and(
                  "connects?(i, P)",
                  s.isConnects(a.i(), a.P()),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j) && s.isActive(j))
                                  || a.P().contains(j)
                                  || s.plist.at(j).contains(a.i())),
                          j ->
                              String.format(
                                  "%s, plist(%s) = %s",
                                  !s.mux.crit_set().at(j).isEmpty()
                                      ? "mux.crit_set(" + j + ") = " + s.mux.crit_set().at(j)
                                      : "mux.req_set(" + j + ") = " + s.mux.req_set().at(j),
                                  j,
                                  s.plist.at(j)),
                          List.of(a.i()),
                          s.mux.crit_set().arguments(),
                          s.mux.req_set().arguments(),
                          a.P(),
                          s.plist.arguments()));
      case MutexGroupAction.known a ->
          Enabled.when(
                  "mux.req_set(i) != {}",
                  !s.mux.req_set().at(a.i()).isEmpty(),
                  () -> "mux.req_set(" + a.i() + ") = " + s.mux.req_set().at(a.i()))
              .and(
                  "connects?(i, P)",
                  s.isConnects(a.i(), a.P()),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j) && s.isActive(j))
                                  || a.P().contains(j)
                                  || s.plist.at(j).contains(a.i())),
                          j ->
                              String.format(
                                  "%s, plist(%s) = %s",
                                  !s.mux.crit_set().at(j).isEmpty()
                                      ? "mux.crit_set(" + j + ") = " + s.mux.crit_set().at(j)
                                      : "mux.req_set(" + j + ") = " + s.mux.req_set().at(j),
                                  j,
                                  s.plist.at(j)),
                          List.of(a.i()),
                          s.mux.crit_set().arguments(),
                          s.mux.req_set().arguments(),
                          a.P(),
                          s.plist.arguments()));
      case MutexGroupAction.od_mutex a ->
          Enabled.when("RS != {}", !a.RS().isEmpty(), () -> "RS = " + a.RS())
              .and(
                  "RS = mux.req_set(i)",
                  a.RS().equals(s.mux.req_set().at(a.i())),
                  () -> "mux.req_set(" + a.i() + ") = " + s.mux.req_set().at(a.i()))
              .and(
                  "forall j: PIDS :: not i = j and (peer?(i, j) or mux.rest_set(j) != {}) => RS disjoint mux.held(j)",
                  Finite.forAll(
                          j ->
                              !(!a.i().equals(j)
                                      && (s.isPeer(a.i(), j) || !s.mux.rest_set().at(j).isEmpty()))
                                  || Sets.disjoint(a.RS(), s.mux.held(j)),
                          List.of(a.i()),
                          s.plist.at(a.i()),
                          s.plist.arguments(),
                          s.mux.rest_set().arguments(),
                          s.mux.crit_set().arguments())
                      && (!(s.plist.defaultValue().contains(a.i())
                              || !s.mux.rest_set().defaultValue().isEmpty())
                          || Sets.disjoint(
                              a.RS(),
                              Sets.union(
                                  s.mux.crit_set().defaultValue(),
                                  s.mux.rest_set().defaultValue()))),
                  () ->
                      Finite.first(
                          j ->
                              !(!(!a.i().equals(j)
                                      && (s.isPeer(a.i(), j) || !s.mux.rest_set().at(j).isEmpty()))
                                  || Sets.disjoint(a.RS(), s.mux.held(j))),
                          j ->
                              String.format(
                                  "%s, held(%s) = %s",
                                  s.isPeer(a.i(), j)
                                      ? (s.plist.at(a.i()).contains(j)
                                          ? "plist(" + a.i() + ") = " + s.plist.at(a.i())
                                          : "plist(" + j + ") = " + s.plist.at(j))
                                      : "mux.rest_set(" + j + ") = " + s.mux.rest_set().at(j),
                                  j,
                                  s.mux.held(j)),
                          List.of(a.i()),
                          s.plist.at(a.i()),
                          s.plist.arguments(),
                          s.mux.rest_set().arguments(),
                          s.mux.crit_set().arguments()));
      case MutexGroupAction.release a ->
          Enabled.when(
              "mux.release(i, RS)",
              muxAutomaton.enabled(new MutexAction.release(a.i(), a.RS()), s.mux));
      case MutexGroupAction.withdraw a ->
          Enabled.when(
              "mux.withdraw(i)", muxAutomaton.enabled(new MutexAction.withdraw(a.i()), s.mux));
      case MutexGroupAction.restart a -> Enabled.TRUE;
      case MutexGroupAction.take_over a ->
          Enabled.when(
              "mux.take_over(i, j)",
              muxAutomaton.enabled(new MutexAction.take_over(a.i(), a.j()), s.mux));
      case MutexGroupAction.stands_in a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(MutexGroupAction action, States s) {
    return switch (action) {
      case MutexGroupAction.do_mutex a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist.with(a.i(), a.P()),
                  Undefined.step(
                      "Mutex_group_decls.starl:38:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.do_mutex(a.i(), a.RS()),
                      s.mux))
              : s;
      case MutexGroupAction.known a -> new States(s.plist.with(a.i(), a.P()), s.mux);
      case MutexGroupAction.od_mutex a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist,
                  Undefined.step(
                      "Mutex_group_decls.starl:48:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.od_mutex(a.i(), a.RS()),
                      s.mux))
              : s;
      case MutexGroupAction.release a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist,
                  Undefined.step(
                      "Mutex_group_decls.starl:52:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.release(a.i(), a.RS()),
                      s.mux))
              : s;
      case MutexGroupAction.withdraw a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist,
                  Undefined.step(
                      "Mutex_group_decls.starl:56:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.withdraw(a.i()),
                      s.mux))
              : s;
      case MutexGroupAction.restart a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist,
                  Undefined.step(
                      "Mutex_group_decls.starl:59:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.restart(a.i()),
                      s.mux))
              : s;
      case MutexGroupAction.take_over a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist,
                  Undefined.step(
                      "Mutex_group_decls.starl:63:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.take_over(a.i(), a.j()),
                      s.mux))
              : s;
      case MutexGroupAction.stands_in a ->
          enabled(action, s).isTrue()
              ? new States(
                  s.plist,
                  Undefined.step(
                      "Mutex_group_decls.starl:66:7",
                      "mux",
                      muxAutomaton,
                      new MutexAction.stands_in(a.i(), a.RS()),
                      s.mux))
              : s;
    };
  }
}

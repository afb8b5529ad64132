// Generated from Registration_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.registration;

import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The automaton Registration_decls, executable.
 *
 * <p>Registration (paper, section 4.3): who takes part, as numbered lists.
 *
 * <p>Ids, one for each attempt to take part, ask to be listed; list n + 1 is decided from list n;
 * ids learn of lists. Every list has all of the list before it but those who may be left out: who
 * has asked out, whose robot has given the id up, or for whose sections somebody else vouches. The
 * time stamp of a list is its number: the paper's agreement, of lists whose times lie within d of
 * each other, does not carry the intersection (theory Registration_rounds).
 *
 * <p>Assumes nothing: any delay and loss is some order of `decide' and `learn'. How long that takes
 * is the matter of Registration_progress. Java: org.starl.primitives.registration.RegPrim; this
 * automaton: RegistrationAutomaton; monitors: RegistrationSpec, RegistrationConformance.
 */
public final class RegistrationAutomaton
    implements Automaton<RegistrationAutomaton.States, RegistrationAction> {

  /** The theory's name. */
  public static final String REGISTRATION_DECLS = "Registration_decls";

  /**
   * The states.
   *
   * @param asked called do_register
   * @param gone may be left out
   * @param entered some list has had it
   * @param number of the latest list
   * @param list list 0 is empty
   * @param ts of the list that i knows; 0: rList is null
   */
  public record States(
      SortedSet<ProcessId> asked,
      SortedSet<ProcessId> gone,
      SortedSet<ProcessId> entered,
      long number,
      Fun<Long, SortedSet<ProcessId>> list,
      Fun<ProcessId, Long> ts) {

    public SortedSet<ProcessId> rList(ProcessId i) {
      return list.at(ts.at(i));
    }

    private States with_asked(SortedSet<ProcessId> asked) {
      return new States(asked, gone, entered, number, list, ts);
    }

    private States with_gone(SortedSet<ProcessId> gone) {
      return new States(asked, gone, entered, number, list, ts);
    }

    private States with_entered(SortedSet<ProcessId> entered) {
      return new States(asked, gone, entered, number, list, ts);
    }

    private States with_number(long number) {
      return new States(asked, gone, entered, number, list, ts);
    }

    private States with_list(Fun<Long, SortedSet<ProcessId>> list) {
      return new States(asked, gone, entered, number, list, ts);
    }

    private States with_ts(Fun<ProcessId, Long> ts) {
      return new States(asked, gone, entered, number, list, ts);
    }
  }

  @Override
  public String theory() {
    return REGISTRATION_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Sets.emptyset(),
        Sets.emptyset(),
        Sets.emptyset(),
        0L,
        Fun.always(Sets.emptyset()),
        Fun.always(0L));
  }

  @Override
  public Enabled enabled(RegistrationAction action, States s) {
    return switch (action) {
      case RegistrationAction.do_register a ->
          Enabled.when("not i in asked", !s.asked.contains(a.i()), () -> "asked = " + s.asked);
      case RegistrationAction.unregister a ->
          Enabled.when("i in asked", s.asked.contains(a.i()), () -> "asked = " + s.asked);
      case RegistrationAction.give_up a ->
          Enabled.when("i in asked", s.asked.contains(a.i()), () -> "asked = " + s.asked);
      case RegistrationAction.confine a ->
          Enabled.when("i in asked", s.asked.contains(a.i()), () -> "asked = " + s.asked);
      case RegistrationAction.decide a ->
          Enabled.when(
                  "list(number) minus gone subset L",
                  a.L().containsAll(Sets.difference(s.list.at(s.number), s.gone)),
                  () ->
                      String.format(
                          "list(%s) = %s, gone = %s", s.number, s.list.at(s.number), s.gone))
              .and(
                  "forall i: PIDS :: i in L => i in list(number) or (i in asked and not i in entered)",
                  Finite.forAll(
                      i ->
                          !a.L().contains(i)
                              || s.list.at(s.number).contains(i)
                              || (s.asked.contains(i) && !s.entered.contains(i)),
                      a.L()),
                  () ->
                      Finite.first(
                          i ->
                              !(!a.L().contains(i)
                                  || s.list.at(s.number).contains(i)
                                  || (s.asked.contains(i) && !s.entered.contains(i))),
                          i ->
                              String.format(
                                  "i = %s, list(%s) = %s, %s",
                                  i,
                                  s.number,
                                  s.list.at(s.number),
                                  !s.asked.contains(i)
                                      ? "asked = " + s.asked
                                      : "entered = " + s.entered),
                          a.L()));
      case RegistrationAction.learn a ->
          Enabled.when(
                  "ts(i) <= n",
                  s.ts.at(a.i()) <= a.n(),
                  () -> "ts(" + a.i() + ") = " + s.ts.at(a.i()))
              .and("n <= number", a.n() <= s.number, () -> "number = " + s.number);
    };
  }

  @Override
  public States trans(RegistrationAction action, States s) {
    return switch (action) {
      case RegistrationAction.do_register a -> s.with_asked(Sets.add(a.i(), s.asked));
      case RegistrationAction.unregister a -> s.with_gone(Sets.add(a.i(), s.gone));
      case RegistrationAction.give_up a -> s.with_gone(Sets.add(a.i(), s.gone));
      case RegistrationAction.confine a -> s.with_gone(Sets.add(a.i(), s.gone));
      case RegistrationAction.decide a ->
          s.with_entered(Sets.union(s.entered, a.L()))
              .with_number(s.number + 1)
              .with_list(s.list.with(s.number + 1, a.L()));
      case RegistrationAction.learn a -> s.with_ts(s.ts.with(a.i(), a.n()));
    };
  }
}

package org.starl.primitives.registration;

import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;

/**
 * The theory {@code Registration_decls} as an executable automaton: numbered lists of participants.
 * {@code PIDS} are ids, one for each attempt. {@link RegistrationConformance} replays runs on it.
 */
public final class RegistrationAutomaton
    implements Automaton<RegistrationAutomaton.States, RegistrationAction> {

  /** The theory's name. */
  public static final String REGISTRATION_DECLS = "Registration_decls";

  private static final SortedSet<ProcessId> EMPTY = Sets.emptyset();

  /**
   * The theory's states.
   *
   * @param asked whether an id has called {@code do_register}
   * @param gone whether an id may be removed
   * @param entered whether some list has contained an id
   * @param number the number of the latest list
   * @param list the lists; list 0 is empty
   * @param ts the number of the list that an id knows
   */
  public record States(
      Fun<ProcessId, Boolean> asked,
      Fun<ProcessId, Boolean> gone,
      Fun<ProcessId, Boolean> entered,
      long number,
      Fun<Long, SortedSet<ProcessId>> list,
      Fun<ProcessId, Long> ts) {

    /** The latest list. */
    SortedSet<ProcessId> latest() {
      return list.at(number);
    }

    /** The list that {@code i} knows. */
    public SortedSet<ProcessId> rList(ProcessId i) {
      return list.at(ts.at(i));
    }

    /** Without an old list, which no step reads. */
    States withoutList(long old) {
      return new States(asked, gone, entered, number, list.with(old, EMPTY), ts);
    }

    private States withGone(ProcessId i) {
      return new States(asked, gone.with(i, true), entered, number, list, ts);
    }
  }

  @Override
  public String theory() {
    return REGISTRATION_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(false),
        Fun.always(false),
        Fun.always(false),
        0,
        Fun.always(EMPTY),
        Fun.always(0L));
  }

  @Override
  public Enabled enabled(RegistrationAction action, States s) {
    return switch (action) {
      case RegistrationAction.do_register a ->
          Enabled.when("NOT asked(i)", !s.asked.at(a.i()), () -> "asked(" + a.i() + ")");
      case RegistrationAction.unregister a -> asked(a.i(), s);
      case RegistrationAction.give_up a -> asked(a.i(), s);
      case RegistrationAction.confine a -> asked(a.i(), s);
      case RegistrationAction.decide a -> mayFollow(a.L(), s);
      case RegistrationAction.learn a ->
          Enabled.when(
                  "ts(i) <= n",
                  s.ts.at(a.i()) <= a.n(),
                  () -> "ts(" + a.i() + ") = " + s.ts.at(a.i()))
              .and("n <= number", a.n() <= s.number, () -> "number = " + s.number);
    };
  }

  private static Enabled asked(ProcessId i, States s) {
    return Enabled.when("asked(i)", s.asked.at(i), () -> "NOT asked(" + i + ")");
  }

  private static Enabled mayFollow(SortedSet<ProcessId> next, States s) {
    SortedSet<ProcessId> before = s.latest();
    SortedSet<ProcessId> lost = those(before, i -> !s.gone.at(i) && !next.contains(i));
    SortedSet<ProcessId> unasked = those(next, i -> !before.contains(i) && !s.asked.at(i));
    SortedSet<ProcessId> back = those(next, i -> !before.contains(i) && s.entered.at(i));
    String isNew = "FORALL i: L(i) IMPLIES list(number)(i) OR ";
    return Enabled.when(
            "subset?(difference(list(number), gone), L)",
            lost.isEmpty(),
            () -> "list(" + s.number + ") has " + lost + " as well")
        .and(isNew + "asked(i)", unasked.isEmpty(), () -> unasked + " never asked")
        .and(isNew + "NOT entered(i)", back.isEmpty(), () -> back + " had entered and left");
  }

  private static SortedSet<ProcessId> those(
      SortedSet<ProcessId> ids, Predicate<ProcessId> condition) {
    SortedSet<ProcessId> those = new TreeSet<>(ids);
    those.removeIf(condition.negate());
    return those;
  }

  @Override
  public States trans(RegistrationAction action, States s) {
    return switch (action) {
      case RegistrationAction.do_register a ->
          new States(s.asked.with(a.i(), true), s.gone, s.entered, s.number, s.list, s.ts);
      case RegistrationAction.unregister a -> s.withGone(a.i());
      case RegistrationAction.give_up a -> s.withGone(a.i());
      case RegistrationAction.confine a -> s.withGone(a.i());
      case RegistrationAction.decide a -> {
        Fun<ProcessId, Boolean> entered = s.entered;
        for (ProcessId i : a.L()) {
          entered = entered.with(i, true);
        }
        long number = s.number + 1;
        yield new States(s.asked, s.gone, entered, number, s.list.with(number, a.L()), s.ts);
      }
      case RegistrationAction.learn a ->
          new States(s.asked, s.gone, s.entered, s.number, s.list, s.ts.with(a.i(), a.n()));
    };
  }
}

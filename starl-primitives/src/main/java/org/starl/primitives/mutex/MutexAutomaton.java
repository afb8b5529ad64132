package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;

/**
 * The theory {@code Mutex_decls} as an executable automaton: mutual exclusion on sets of zones.
 * {@code PIDS} are robots, {@code Zones} names of sections. {@link MutexConformance} replays runs
 * on it.
 */
public final class MutexAutomaton implements Automaton<MutexAutomaton.States, MutexAction> {

  /** The theory's name. */
  public static final String MUTEX_DECLS = "Mutex_decls";

  /**
   * The theory's states.
   *
   * @param crit_set the sections that the robot's present program holds
   * @param req_set the sections that it waits for
   * @param rest_set the sections that earlier starts of its program held: its body may still be
   *     there
   */
  public record States(
      Fun<RobotId, SortedSet<String>> crit_set,
      Fun<RobotId, SortedSet<String>> req_set,
      Fun<RobotId, SortedSet<String>> rest_set) {

    /** All sections that no other robot may hold because of {@code i}. */
    public SortedSet<String> held(RobotId i) {
      TreeSet<String> held = new TreeSet<>(crit_set.at(i));
      held.addAll(rest_set.at(i));
      return Sections.copyOf(held);
    }
  }

  @Override
  public String theory() {
    return MUTEX_DECLS;
  }

  @Override
  public States start() {
    Fun<RobotId, SortedSet<String>> empty = Fun.always(Sections.NONE);
    return new States(empty, empty, empty);
  }

  @Override
  public Enabled enabled(MutexAction action, States s) {
    RobotId i = action.i();
    return switch (action) {
      case MutexAction.do_mutex a ->
          nonempty(a.RS())
              .and(
                  "empty?(req_set(i, s))",
                  s.req_set.at(i).isEmpty(),
                  () -> at("req_set", i, s.req_set))
              .and(
                  "empty?(crit_set(i, s))",
                  s.crit_set.at(i).isEmpty(),
                  () -> at("crit_set", i, s.crit_set));
      case MutexAction.od_mutex a ->
          nonempty(a.RS())
              .and(
                  "RS = req_set(i, s)",
                  a.RS().equals(s.req_set.at(i)),
                  () -> at("req_set", i, s.req_set))
              .and("free_for?(i, RS, s)", isFreeFor(i, a.RS(), s), () -> holders(i, a.RS(), s));
      case MutexAction.release a ->
          Enabled.when(
              "subset?(RS, crit_set(i, s))",
              s.crit_set.at(i).containsAll(a.RS()),
              () -> at("crit_set", i, s.crit_set));
      case MutexAction.withdraw a ->
          Enabled.when(
              "nonempty?(req_set(i, s))",
              !s.req_set.at(i).isEmpty(),
              () -> at("req_set", i, s.req_set));
      case MutexAction.restart a -> Enabled.TRUE;
      case MutexAction.stands_in a -> Enabled.TRUE;
    };
  }

  @Override
  public States trans(MutexAction action, States s) {
    RobotId i = action.i();
    return switch (action) {
      case MutexAction.do_mutex a -> new States(s.crit_set, s.req_set.with(i, a.RS()), s.rest_set);
      case MutexAction.od_mutex a ->
          new States(s.crit_set.with(i, a.RS()), s.req_set.with(i, Sections.NONE), s.rest_set);
      case MutexAction.release a ->
          new States(
              s.crit_set.with(i, Sections.without(s.crit_set.at(i), a.RS())),
              s.req_set,
              s.rest_set);
      case MutexAction.withdraw a ->
          new States(s.crit_set, s.req_set.with(i, Sections.NONE), s.rest_set);
      case MutexAction.restart a ->
          new States(
              s.crit_set.with(i, Sections.NONE),
              s.req_set.with(i, Sections.NONE),
              s.rest_set.with(i, s.held(i)));
      case MutexAction.stands_in a ->
          new States(
              s.crit_set, s.req_set, s.rest_set.with(i, Sections.common(s.rest_set.at(i), a.RS())));
    };
  }

  private static boolean isFreeFor(RobotId i, SortedSet<String> sections, States s) {
    return isFreeFor(i, sections, s.crit_set) && isFreeFor(i, sections, s.rest_set);
  }

  private static boolean isFreeFor(
      RobotId i, SortedSet<String> sections, Fun<RobotId, SortedSet<String>> held) {
    return held.allMatch((j, its) -> j.equals(i) || !Sections.meet(sections, its));
  }

  private static Enabled nonempty(SortedSet<String> sections) {
    return Enabled.when("nonempty?(RS)", !sections.isEmpty(), () -> "RS = []");
  }

  private static String at(String component, RobotId i, Fun<RobotId, SortedSet<String>> of) {
    return component + "(" + i + ", s) = " + of.at(i);
  }

  private static String holders(RobotId i, SortedSet<String> sections, States s) {
    TreeSet<RobotId> holders = new TreeSet<>();
    for (Fun<RobotId, SortedSet<String>> held : List.of(s.crit_set, s.rest_set)) {
      held.forEach((j, its) -> {
        if (!j.equals(i) && Sections.meet(sections, its)) {
          holders.add(j);
        }
      });
    }
    StringBuilder text = new StringBuilder();
    for (RobotId j : holders) {
      text.append(text.length() == 0 ? "" : ", ").append("held(").append(j).append(", s) = ");
      text.append(s.held(j));
    }
    return text.toString();
  }
}

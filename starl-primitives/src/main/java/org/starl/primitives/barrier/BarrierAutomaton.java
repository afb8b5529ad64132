package org.starl.primitives.barrier;

import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Term;

/**
 * The theory {@code Barrier_decls} as an executable automaton: in each generation, all members arrive
 * and are told one outcome. {@code PIDS} are ids, one for each start of a robot's program. {@link
 * BarrierConformance} replays runs on it.
 */
public final class BarrierAutomaton implements Automaton<BarrierAutomaton.States, BarrierAction> {

  /** The theory's name. */
  public static final String BARRIER_DECLS = "Barrier_decls";

  private final SortedSet<ProcessId> first;

  /**
   * @param first the theory's parameter: the members of generation 1
   */
  public BarrierAutomaton(SortedSet<ProcessId> first) {
    this.first = Collections.unmodifiableSortedSet(new TreeSet<>(first));
  }

  /** The theory's data type of outcomes. */
  public sealed interface Outcome extends Term {

    /** None yet. */
    // The theory's name; in module declarations it is a keyword.
    @SuppressWarnings("NamedLikeContextualKeyword")
    record open() implements Outcome {
      @Override
      public String toString() {
        return text();
      }
    }

    /** All members arrived. */
    record passed() implements Outcome {
      @Override
      public String toString() {
        return text();
      }
    }

    /** The missing members are excluded. */
    record failed(SortedSet<ProcessId> missing) implements Outcome {
      @Override
      public String toString() {
        return text();
      }
    }

    @Override
    default List<Object> args() {
      return this instanceof failed some ? List.of(some.missing) : List.of();
    }
  }

  /** The latest outcome that an id was told, and its generation. */
  public record Told(long gen, Outcome out) {}

  /**
   * The theory's states.
   *
   * @param arrived the ids that arrived in a generation
   * @param outcome the outcome of a generation
   * @param told the outcome that an id shows
   */
  public record States(
      Fun<Long, SortedSet<ProcessId>> arrived,
      Fun<Long, Outcome> outcome,
      Fun<ProcessId, Told> told) {

    /** Whether {@code g} has no outcome. */
    boolean isOpen(long g) {
      return outcome.at(g) instanceof Outcome.open;
    }

    /** Without the arrivals in a decided generation, which no action reads. */
    States withoutArrivals(long g) {
      return new States(arrived.with(g, Sets.emptyset()), outcome, told);
    }
  }

  @Override
  public String theory() {
    return BARRIER_DECLS;
  }

  /** The theory's parameter. */
  SortedSet<ProcessId> first() {
    return first;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Sets.emptyset()),
        Fun.always(new Outcome.open()),
        Fun.always(new Told(0, new Outcome.open())));
  }

  /** The members of a generation: the initial members minus those excluded earlier. */
  public SortedSet<ProcessId> members(long g, States s) {
    SortedSet<ProcessId> members = new TreeSet<>(first);
    s.outcome.forEach((before, outcome) -> {
      if (0 < before && before < g && outcome instanceof Outcome.failed some) {
        members.removeAll(some.missing());
      }
    });
    return members;
  }

  @Override
  public Enabled enabled(BarrierAction action, States s) {
    return switch (action) {
      case BarrierAction.arrive a -> Enabled.TRUE;
      case BarrierAction.decide a ->
          right(
              Enabled.when(
                  "open?(outcome(g))",
                  s.isOpen(a.g()),
                  () -> "outcome(" + a.g() + ") = " + s.outcome.at(a.g())),
              a.g(),
              a.o(),
              s);
      case BarrierAction.tell a ->
          Enabled.when(
              "NOT open?(outcome(g))",
              !s.isOpen(a.g()),
              () -> "outcome(" + a.g() + ") = " + s.outcome.at(a.g()));
    };
  }

  /** The theory's {@code right?(g, o, s)}, after other conjuncts. */
  private Enabled right(Enabled before, long g, Outcome o, States s) {
    Enabled inOrder =
        before
            .and("g > 0", g > 0, () -> "g = " + g)
            .and(
                "g = 1 OR NOT open?(outcome(g - 1))",
                g == 1 || !s.isOpen(g - 1),
                () -> "outcome(" + (g - 1) + ") = " + s.outcome.at(g - 1));
    return switch (o) {
      case Outcome.open none -> inOrder.and("NOT open?(o)", false, () -> "o = " + none);
      case Outcome.passed all -> {
        SortedSet<ProcessId> late = members(g, s);
        late.removeAll(s.arrived.at(g));
        yield inOrder.and(
            "subset?(members(g, s), arrived(g))",
            late.isEmpty(),
            () -> late + " have not arrived in " + g);
      }
      case Outcome.failed some -> {
        SortedSet<ProcessId> members = members(g, s);
        yield inOrder
            .and("nonempty?(M)", !some.missing().isEmpty(), () -> "M = " + some.missing())
            .and(
                "subset?(M, members(g, s))",
                members.containsAll(some.missing()),
                () -> "members(" + g + ", s) = " + members);
      }
    };
  }

  @Override
  public States trans(BarrierAction action, States s) {
    return switch (action) {
      case BarrierAction.arrive a -> {
        SortedSet<ProcessId> arrived = Sets.add(a.i(), s.arrived.at(a.g()));
        yield new States(s.arrived.with(a.g(), arrived), s.outcome, s.told);
      }
      case BarrierAction.decide a -> new States(s.arrived, s.outcome.with(a.g(), a.o()), s.told);
      case BarrierAction.tell a -> {
        Told told = new Told(a.g(), s.outcome.at(a.g()));
        yield new States(s.arrived, s.outcome, s.told.with(a.i(), told));
      }
    };
  }
}

// Generated from Barrier_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.barrier;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Automaton;
import org.starl.spec.automaton.Enabled;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Term;
import org.starl.spec.automaton.Undefined;

/**
 * The automaton Barrier_decls, executable.
 *
 * <p>Barrier synchronisation (the paper names it among StarL's primitives, section 4): generation
 * by generation, all members arrive and are told one outcome.
 *
 * <p>Generations are 1, 2, 3, ...; `first' are the members of generation 1. A generation is passed
 * once all its members have arrived in it, or broken by the absence of some, who are members of no
 * later one. Outcomes come in the order of the generations; an arrival may come at any time, and
 * counts for its own generation. Whoever is told of a generation is told its outcome (a process
 * that is among the missing is thereby told excluded).
 *
 * <p>Nothing is assumed. PIDS are ids: a robot that restarts is another participant. Java:
 * org.starl.primitives.barrier.Barrier; `outcome' is what is true of the whole system, `told(i)' is
 * what i shows; this automaton: BarrierAutomaton; monitors: BarrierSpec, BarrierConformance.
 */
public final class BarrierAutomaton implements Automaton<BarrierAutomaton.States, BarrierAction> {

  /** The theory's name. */
  public static final String BARRIER_DECLS = "Barrier_decls";

  private final SortedSet<ProcessId> first;

  /** Of the theory's parameters. */
  public BarrierAutomaton(SortedSet<ProcessId> first) {
    this.first = Sets.of(first);
  }

  /** The theory's parameter. */
  public SortedSet<ProcessId> first() {
    return first;
  }

  public sealed interface Outcome extends Term, Comparable<Outcome> {

    // The theory's name; in module declarations it is a keyword.
    @SuppressWarnings("NamedLikeContextualKeyword")
    record open() implements Outcome {
      @Override
      public String toString() {
        return text();
      }
    }

    record passed() implements Outcome {
      @Override
      public String toString() {
        return text();
      }
    }

    record failed(SortedSet<ProcessId> missing) implements Outcome {
      @Override
      public String toString() {
        return text();
      }
    }

    @Override
    default List<Object> args() {
      return switch (this) {
        case open a -> List.of();
        case passed a -> List.of();
        case failed a -> List.of(a.missing);
      };
    }

    @Override
    default int compareTo(Outcome that) {
      return Sets.compare(this, that);
    }
  }

  public record Told(long gen, Outcome out) implements Comparable<Told> {

    @Override
    public int compareTo(Told that) {
      int order = Sets.compare(this.gen, that.gen);
      if (order == 0) {
        order = Sets.compare(this.out, that.out);
      }
      return order;
    }
  }

  /** The states. */
  public record States(
      Fun<Long, SortedSet<ProcessId>> arrived,
      Fun<Long, Outcome> outcome,
      Fun<ProcessId, Told> told) {}

  @Override
  public String theory() {
    return BARRIER_DECLS;
  }

  @Override
  public States start() {
    return new States(
        Fun.always(Sets.emptyset()),
        Fun.always(new Outcome.open()),
        Fun.always(new Told(0L, new Outcome.open())));
  }

  /** The members of a generation: the first without whom those before left out. */
  public SortedSet<ProcessId> members(long g, States s) {
    SortedSet<ProcessId> value = Sets.emptyset();
    for (long g_ = 0; g_ <= g; g_++) {
      value =
          g_ <= 1
              ? first
              : s.outcome.at(Undefined.difference("Barrier_decls.starl:35:19", g_, 1))
                      instanceof Outcome.failed
                  ? Sets.difference(
                      value,
                      Undefined.form(
                              "Barrier_decls.starl:35:62",
                              "missing",
                              Outcome.failed.class,
                              s.outcome.at(
                                  Undefined.difference("Barrier_decls.starl:35:70", g_, 1)))
                          .missing())
                  : value;
    }
    return value;
  }

  /**
   * o may be the outcome of g: those before have theirs, and all have arrived, or some of them are
   * missing.
   */
  public boolean isRight(long g, Outcome o, States s) {
    return g > 0
        && (g == 1
            || !(s.outcome.at(Undefined.difference("Barrier_decls.starl:42:35", g, 1))
                instanceof Outcome.open))
        && (o instanceof Outcome.open
            ? false
            : o instanceof Outcome.failed failed_
                ? !failed_.missing().isEmpty() && members(g, s).containsAll(failed_.missing())
                : s.arrived.at(g).containsAll(members(g, s)));
  }

  @Override
  public Enabled enabled(BarrierAction action, States s) {
    return switch (action) {
      case BarrierAction.arrive a -> Enabled.TRUE;
      case BarrierAction.decide a ->
          Enabled.when(
                  "outcome(g) is open",
                  s.outcome.at(a.g()) instanceof Outcome.open,
                  () -> "outcome(" + a.g() + ") = " + s.outcome.at(a.g()))
              .and(
                  "right?(g, o)",
                  () -> isRight(a.g(), a.o(), s),
                  () ->
                      !(a.g() > 0
                              && (a.g() == 1 || !(s.outcome.at(a.g() - 1) instanceof Outcome.open)))
                          ? (!(a.g() > 0)
                              ? "g = " + a.g()
                              : "outcome(" + (a.g() - 1) + ") = " + s.outcome.at(a.g() - 1))
                          : a.o() instanceof Outcome.open
                              ? "o = " + a.o()
                              : a.o() instanceof Outcome.failed failed_
                                  ? (failed_.missing().isEmpty()
                                      ? "M = " + failed_.missing()
                                      : "members(" + a.g() + ") = " + members(a.g(), s))
                                  : String.format(
                                      "members(%s) = %s, arrived(%s) = %s",
                                      a.g(), members(a.g(), s), a.g(), s.arrived.at(a.g())));
      case BarrierAction.tell a ->
          Enabled.when(
              "not outcome(g) is open",
              !(s.outcome.at(a.g()) instanceof Outcome.open),
              () -> "outcome(" + a.g() + ") = " + s.outcome.at(a.g()));
    };
  }

  @Override
  public States trans(BarrierAction action, States s) {
    return switch (action) {
      case BarrierAction.arrive a ->
          new States(
              s.arrived.with(a.g(), Sets.add(a.i(), s.arrived.at(a.g()))), s.outcome, s.told);
      case BarrierAction.decide a -> new States(s.arrived, s.outcome.with(a.g(), a.o()), s.told);
      case BarrierAction.tell a ->
          new States(
              s.arrived, s.outcome, s.told.with(a.i(), new Told(a.g(), s.outcome.at(a.g()))));
    };
  }
}

package org.starl.cli.report;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Reached;

/**
 * What runs reached. Of the theories: each action of the automata, and the values of each conjunct of
 * their guards, for the actions that were taken and for some of them at other times. Of the
 * protocols: the {@link Deliveries}.
 */
public final class Coverage {

  /** How often a conjunct was evaluated, by its value. */
  record Values(long held, long failed) {

    Values plus(Values other) {
      return new Values(held + other.held, failed + other.failed);
    }
  }

  /**
   * One action of a theory.
   *
   * @param taken how often
   * @param guard the evaluated conjuncts of its guard
   */
  record Action(long taken, SortedMap<String, Values> guard) {

    static final Action NEVER = new Action(0, new TreeMap<>());

    Action plus(Action other) {
      SortedMap<String, Values> sum = new TreeMap<>(guard);
      other.guard.forEach((conjunct, values) -> sum.merge(conjunct, values, Values::plus));
      return new Action(taken + other.taken, sum);
    }

    private long seenFalse() {
      return guard.values().stream().filter(values -> values.failed > 0).count();
    }
  }

  /**
   * The coverage as a row of a shard has it.
   *
   * @param theories by the theory's name and the action's
   */
  record Parts(SortedMap<String, SortedMap<String, Action>> theories, Deliveries deliveries) {

    /** Of all that was reached: an action, a conjunct that was false, a delivery. */
    List<String> names() {
      List<String> names = new ArrayList<>(deliveries.names());
      theories.forEach((theory, actions) ->
          actions.forEach((name, action) -> {
            if (action.taken > 0) {
              names.add(theory + "." + name);
            }
            action.guard.forEach((conjunct, values) -> {
              if (values.failed > 0) {
                names.add(theory + "." + name + ": " + conjunct);
              }
            });
          }));
      return names;
    }
  }

  private final SortedMap<String, SortedMap<String, Action>> theories;
  private final Deliveries deliveries;

  @JsonCreator(mode = JsonCreator.Mode.DELEGATING)
  Coverage(Parts parts) {
    theories = parts.theories;
    deliveries = parts.deliveries;
  }

  /** Of no run. */
  public Coverage() {
    this(new Parts(new TreeMap<>(), new Deliveries()));
  }

  @JsonValue
  Parts parts() {
    return new Parts(theories, deliveries);
  }

  /**
   * Of one run.
   *
   * @param counter an observer of the run
   */
  public static Coverage of(SpecReport report, DeliveryCounter counter) {
    Coverage coverage = new Coverage(new Parts(new TreeMap<>(), counter.deliveries()));
    for (Map.Entry<Reached, Long> entry : report.reached().entrySet()) {
      Reached reached = entry.getKey();
      Class<?> action = reached.action();
      SortedMap<String, Action> actions =
          coverage.theories.computeIfAbsent(reached.theory(), any -> actions(action));
      long times = entry.getValue();
      SortedMap<String, Values> guard = new TreeMap<>();
      if (!reached.conjunct().isEmpty()) {
        guard.put(
            reached.conjunct(), reached.holds() ? new Values(times, 0) : new Values(0, times));
      }
      Action more = new Action(guard.isEmpty() ? times : 0, guard);
      actions.merge(action.getSimpleName(), more, Action::plus);
    }
    return coverage;
  }

  /** All actions of the theory of {@code action}, which is one of a sealed interface. */
  private static SortedMap<String, Action> actions(Class<?> action) {
    SortedMap<String, Action> actions = new TreeMap<>();
    for (Class<?> type : action.getInterfaces()) {
      if (type.isSealed()) {
        for (Class<?> other : type.getPermittedSubclasses()) {
          actions.put(other.getSimpleName(), Action.NEVER);
        }
      }
    }
    return actions;
  }

  /** Adds other runs. */
  public void add(Coverage other) {
    other.theories.forEach((theory, actions) -> {
      SortedMap<String, Action> sums = theories.computeIfAbsent(theory, any -> new TreeMap<>());
      actions.forEach((name, action) -> sums.merge(name, action, Action::plus));
    });
    deliveries.add(other.deliveries);
  }

  SortedMap<String, SortedMap<String, Action>> theories() {
    return Collections.unmodifiableSortedMap(theories);
  }

  /** The table of each channel with a delivery. */
  List<Deliveries.Table> deliveries() {
    return deliveries.tables();
  }

  /** A line for each theory, then one for each channel with a delivery. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    theories.forEach((theory, actions) -> {
      long taken = actions.values().stream().filter(action -> action.taken > 0).count();
      long guards = actions.values().stream().mapToLong(action -> action.guard.size()).sum();
      long seenFalse = actions.values().stream().mapToLong(Action::seenFalse).sum();
      List<String> never =
          actions.entrySet().stream()
              .filter(action -> action.getValue().taken == 0)
              .map(Map.Entry::getKey)
              .toList();
      lines.add(
          "coverage of %s: %d of %d actions, %d of %d guards seen false%s"
              .formatted(
                  theory,
                  taken,
                  actions.size(),
                  seenFalse,
                  guards,
                  never.isEmpty() ? "" : "; never: " + String.join(" ", never)));
    });
    lines.addAll(deliveries.lines());
    return lines;
  }
}

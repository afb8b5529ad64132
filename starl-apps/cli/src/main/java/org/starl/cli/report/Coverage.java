package org.starl.cli.report;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Reached;

/**
 * What runs reached of the theories: each action of the automata, and each conjunct of their guards
 * that was false for an action that was taken at another time.
 */
public final class Coverage {

  /**
   * One action of a theory.
   *
   * @param taken how often
   * @param falseGuards conjuncts of its guard that were false
   */
  record Action(long taken, SortedSet<String> falseGuards) {

    static final Action NEVER = new Action(0, new TreeSet<>());

    Action plus(Action other) {
      SortedSet<String> guards = new TreeSet<>(falseGuards);
      guards.addAll(other.falseGuards);
      return new Action(taken + other.taken, guards);
    }
  }

  /** By the theory's name and the action's. */
  @JsonValue private final SortedMap<String, SortedMap<String, Action>> theories;

  @JsonCreator(mode = JsonCreator.Mode.DELEGATING)
  Coverage(SortedMap<String, SortedMap<String, Action>> theories) {
    this.theories = theories;
  }

  /** Of no run. */
  public Coverage() {
    this(new TreeMap<>());
  }

  /** Of one run. */
  public static Coverage of(SpecReport report) {
    Coverage coverage = new Coverage();
    for (Map.Entry<Reached, Long> entry : report.reached().entrySet()) {
      Reached reached = entry.getKey();
      Class<?> action = reached.action();
      SortedMap<String, Action> actions =
          coverage.theories.computeIfAbsent(reached.theory(), any -> actions(action));
      boolean isTaken = reached.guard().isEmpty();
      Action more =
          isTaken
              ? new Action(entry.getValue(), new TreeSet<>())
              : new Action(0, new TreeSet<>(List.of(reached.guard())));
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
  }

  /** A line for each theory; none without a theory. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    theories.forEach((theory, actions) -> {
      long taken = actions.values().stream().filter(action -> action.taken > 0).count();
      int guards = actions.values().stream().mapToInt(action -> action.falseGuards.size()).sum();
      List<String> never =
          actions.entrySet().stream()
              .filter(action -> action.getValue().taken == 0)
              .map(Map.Entry::getKey)
              .toList();
      lines.add(
          "coverage of %s: %d of %d actions, %d guards seen false%s"
              .formatted(
                  theory,
                  taken,
                  actions.size(),
                  guards,
                  never.isEmpty() ? "" : "; never: " + String.join(" ", never)));
    });
    return lines;
  }
}

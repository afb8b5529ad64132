package org.starl.lang.check;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.starl.lang.eval.Sizes;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Refinement;
import org.starl.lang.verdict.Verdict;

/** The result of a search in words. It has no times: equal searches have equal reports. */
public final class Report {

  private static final int MOST_NAMED = 8;

  private Report() {}

  /**
   * The lines; all but the first are indented.
   *
   * @param file the name of an automaton's file
   */
  public static List<String> lines(
      Automaton automaton, Sizes sizes, Search.Result result, UnaryOperator<String> file) {
    List<String> lines = new ArrayList<>();
    String head = head(automaton, sizes, result.bounded()) + ": ";
    String counts =
        "%s, %s, at most %s from a start"
            .formatted(
                count(result.states(), "state"),
                count(result.steps(), "step"),
                count(result.depth(), "step"));
    result
        .finding()
        .ifPresentOrElse(
            finding -> {
              String name = finding.name().isEmpty() ? "a step" : finding.name();
              String unasked = String.join(", ", finding.unasked());
              lines.add(
                  head
                      + (unasked.isEmpty() ? "" : "not decided: ")
                      + (name + " " + finding.what())
                      + (unasked.isEmpty() ? "" : " if " + unasked + " holds of the first state"));
              finding.story().forEach(line -> lines.add("  " + line));
              lines.add(
                  "  %s:%s: %s"
                      .formatted(
                          file.apply(finding.automaton()), finding.pos(), finding.message()));
            },
            () -> lines.add(head + counts + "; " + verdict(automaton, result) + never(result)));
    addNotes(lines, sizes, result);
    if (result.outside() == 0 && result.isComplete()) {
      automaton
          .constraints()
          .forEach(each -> lines.add("  never false: constraint " + each.name()));
    }
    automaton.refinements().forEach(each -> addUnused(lines, each, result));
    addFairness(lines, automaton);
    return List.copyOf(lines);
  }

  private static void addNotes(List<String> lines, Sizes sizes, Search.Result result) {
    if (!result.stopped().isEmpty()) {
      lines.add(
          "  the search ended early: "
              + result.stopped()
              + "; to go on, repeat it with a larger --most, more memory"
              + " (STARL_JAVA_OPTS=-Xmx...), or smaller sizes (--robots, --size, --nat, --time)");
    }
    if (result.states() + result.outside() == 0 && result.finding().isEmpty()) {
      lines.add("  no values %s meet the assumptions and the start".formatted(within(sizes)));
    }
    if (!result.asymmetric().isEmpty()) {
      lines.add(
          "  of some states that differ in the names of elements alone, more than one counts: too many orders of "
              + String.join(", ", result.asymmetric()));
    }
    if (!result.symmetric().isEmpty()) {
      lines.add(
          "  states that differ in the names of elements alone count once: "
              + String.join(", ", result.symmetric()));
    }
    if (result.outside() > 0) {
      lines.add(
          "  %s outside, whose steps are not looked at"
              .formatted(count(result.outside(), "state")));
    }
    result
        .open()
        .forEach(part -> lines.add("  the start leaves open: " + part + ", each value is tried"));
    result
        .cut()
        .forEach(part ->
            lines.add("  the start leaves open: " + part + ", ONLY THE FIRST VALUE is tried"));
    if (result.beyond() > 0) {
      lines.add(
          "  not taken: %s beyond --nat %d, --time %d"
              .formatted(count(result.beyond(), "step"), sizes.nat(), sizes.time()));
    }
    if (result.beyondArguments() > 0) {
      lines.add(
          "  not taken: steps with arguments beyond --nat %d, in %s"
              .formatted(sizes.nat(), count(result.beyondArguments(), "case")));
    }
    if (!result.untried().isEmpty()) {
      lines.add(
          "  not each value is tried, but whole ones %s: %s"
              .formatted(within(sizes), String.join(", ", result.untried())));
    }
    result
        .unevaluated()
        .forEach((invariant, states) ->
            lines.add(
                "  not evaluated: %s in %s, which need values beyond --nat %d, --time %d"
                    .formatted(invariant, count(states, "state"), sizes.nat(), sizes.time())));
    result
        .neverFalse()
        .forEach((action, texts) ->
            texts.forEach(text -> lines.add("  never false: '" + text + "' of " + action)));
  }

  /** The steps of an abstract automaton that no action that happens takes. */
  private static void addUnused(List<String> lines, Refinement of, Search.Result result) {
    Set<String> unused = new LinkedHashSet<>();
    of.of().actions().forEach(action -> unused.add(action.name()));
    of.steps()
        .forEach((action, steps) -> {
          if (!result.never().contains(action)) {
            steps.forEach(step -> unused.remove(step.action().name()));
          }
        });
    if (result.finding().isEmpty() && !unused.isEmpty()) {
      lines.add("  never a step of " + of.name() + ": " + String.join(", ", unused));
    }
  }

  /** Of which runs progress was asked. */
  private static void addFairness(List<String> lines, Automaton automaton) {
    if (Search.needsGraph(automaton)) {
      String fair = String.join("; ", automaton.fairness());
      lines.add(
          "  progress is of runs that may stop where nothing fair is possible; "
              + (fair.isEmpty() ? "no action is fair" : fair));
      lines.add("  states that differ in the names of elements alone count each, for progress");
    }
  }

  private static String within(Sizes sizes) {
    return "to --nat %d, --time %d".formatted(sizes.nat(), sizes.time());
  }

  private static String never(Search.Result result) {
    return result.never().isEmpty() ? "" : "; never happens: " + String.join(", ", result.never());
  }

  /** An automaton with its sizes: {@code Bridge (PIDS 3)}. */
  public static String head(Automaton automaton, Sizes sizes, Set<String> bounded) {
    List<String> texts = new ArrayList<>();
    sizes.opaque().forEach((type, size) -> texts.add(type + " " + size));
    sizes.numbers().forEach((parameter, number) -> texts.add(parameter + " " + number));
    bounded.forEach(parameter -> texts.add(parameter + " " + within(sizes)));
    return automaton.name() + (texts.isEmpty() ? "" : " (" + String.join(", ", texts) + ")");
  }

  private static String verdict(Automaton automaton, Search.Result result) {
    if (result.verdict() == Verdict.NOT_DECIDED) {
      return "not decided: "
          + String.join(", ", result.undecided())
          + (result.states() == 0 ? "" : "; nothing is wrong so far");
    }
    String within =
        result.outside() == 0
            ? ""
            : automaton.constraints().stream()
                .map(Invariant::name)
                .collect(Collectors.joining(", ", " within ", ""));
    List<String> names =
        Stream.concat(
                automaton.refined().invariants().stream().map(Invariant::name),
                automaton.claims().stream())
            .toList();
    if (names.size() > MOST_NAMED) {
      List<String> refined = automaton.refinements().stream().map(Refinement::title).toList();
      String and =
          (refined.isEmpty() ? "" : " and " + String.join(", ", refined))
              + (automaton.claims().isEmpty() ? "" : " and progress");
      return "all %d invariants%s hold%s".formatted(names.size() - refined.size(), and, within);
    }
    return switch (names.size()) {
      case 0 -> "it has no invariant";
      case 1 -> names.getFirst() + " holds" + within;
      default -> String.join(", ", names) + " hold" + within;
    };
  }

  static String count(long number, String noun) {
    return "%,d %s%s".formatted(number, noun, number == 1 ? "" : "s");
  }
}

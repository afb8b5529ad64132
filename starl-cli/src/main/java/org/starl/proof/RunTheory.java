package org.starl.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.proof.Expressions.Formal;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Term;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/** The run of one instance as a theory: add its steps, then write its text. */
final class RunTheory {

  /** One step of the automaton. */
  private record Step(TraceEvent event, Action action, Record after, List<Result> results) {}

  /** {@code function(argument, after)} is {@code value}. */
  private record Result(String function, Object argument, Object value) {}

  private final String instance;
  private final String library;
  private final List<Formal> formals;
  private final Record first;
  private final Set<String> fields = new TreeSet<>();
  private final List<Step> steps = new ArrayList<>();
  private final Identifiers identifiers = new Identifiers();
  private final Expressions expressions;
  private final StringBuilder text = new StringBuilder();

  /**
   * @param instance {@code mutex/crossing}
   * @param library the theory of the automaton
   * @param formals its type parameters, in order
   * @param first the start state of the run
   */
  RunTheory(String instance, String library, List<Formal> formals, Record first) {
    this.instance = instance;
    this.library = library;
    this.formals = formals;
    this.first = first;
    expressions = new Expressions(formals, identifiers);
    for (var component : first.getClass().getRecordComponents()) {
      fields.add(component.getName());
    }
    formals.forEach(formal -> identifiers.reserve(formal.type()));
    fields.forEach(identifiers::reserve);
  }

  void stepped(TraceEvent event, Action action, Record after) {
    identifiers.reserve(action.name());
    steps.add(new Step(event, action, after, new ArrayList<>()));
  }

  void resulted(String function, Object argument, Object value) {
    if (!steps.isEmpty() && expressions.isValue(value)) {
      steps.get(steps.size() - 1).results().add(new Result(function, argument, value));
    }
  }

  /**
   * The theory's text; to be called once.
   *
   * @param run a description of the run
   */
  String text(String run) {
    String name = "run_" + Identifiers.plain(instance);
    int results = steps.stream().mapToInt(step -> step.results().size()).sum();
    line(
        String.format(
            "%% %s: %s, as a run of %s: %d steps, %d results",
            run, instance, library, steps.size(), results));
    line(name + ": THEORY");
    line("BEGIN");
    String start = expressions.ofState(first); // it tells what the theory must import
    addTypes();
    line("");
    addState(0, start);
    for (int n = 1; n <= steps.size(); n++) {
      Step step = steps.get(n - 1);
      line("");
      line("  % " + description(step.event()));
      line("  a_" + n + ": actions = " + expressions.of(step.action()));
      addState(n, expressions.ofState(step.after()));
    }
    addLemma("begins", "start(s_0)", "(grind)");
    addLemma(
        "reached_0",
        "reachable(s_0)",
        "(then (lemma \"begins\") (lemma \"reachable_start\" (\"s\" \"s_0\")) (assert))");
    for (int n = 1; n <= steps.size(); n++) {
      addStep("s_" + (n - 1), n, steps.get(n - 1));
    }
    line("END " + name);
    return text.toString();
  }

  private void addTypes() {
    for (Formal formal : formals) {
      SortedSet<Comparable<?>> constants = constants(formal.values());
      String names =
          constants.isEmpty()
              ? identifiers.of("no_" + formal.type().toLowerCase(Locale.ROOT))
              : constants.stream().map(identifiers::of).collect(Collectors.joining(", "));
      line("  " + formal.type() + ": TYPE = {" + names + "}");
    }
    identifiers
        .all()
        .forEach((value, name) -> {
          if (!value.toString().equals(name)) {
            line("  % " + name + " is " + value);
          }
        });
    String actuals = formals.stream().map(Formal::type).collect(Collectors.joining(", "));
    String more = expressions.usesConstantly() ? ", " + Expressions.CONSTANTLY : "";
    line("  IMPORTING " + library + "[" + actuals + "]" + more);
  }

  private void addState(int n, String state) {
    line("  s_" + n + ": states =");
    line("    " + state);
  }

  private void addStep(String before, int n, Step step) {
    String action = "a_" + n;
    String after = "s_" + n;
    addLemma(
        "step_" + n,
        "enabled(%s, %s) AND trans(%s, %s) = %s".formatted(action, before, action, before, after),
        proofOfStep(after, step.action()));
    String name = "result_" + n;
    int number = 1;
    for (Result result : step.results()) {
      String claim = function(result, after) + " = " + expressions.of(result.value());
      addLemma(number == 1 ? name : name + "_" + number, claim, "(grind-with-ext)");
      number++;
    }
    addLemma(
        "reached_" + n,
        "reachable(" + after + ")",
        String.format(
            "(then (lemma \"reached_%d\") (lemma \"step_%d\") (flatten)"
                + " (lemma \"reachable_step\" (\"s\" \"%s\" \"a\" \"%s\")) (assert))",
            n - 1, n, before, action));
  }

  /**
   * Rewriting proves it, unless a step sets a constant function to the value that it has already:
   * then the proof needs a case for the point that is set. The point is the action's first argument
   * of a type parameter; a registration's {@code decide} has none, and adds list {@code number}.
   */
  private String proofOfStep(String after, Action action) {
    String point =
        action.args().stream()
            .filter(formals.get(0).values()::isInstance)
            .map(expressions::of)
            .findFirst()
            .orElse(after + "`number");
    return "(then (split) (grind-with-ext) (case \"x!1 = " + point + "\") (grind))";
  }

  /** A component of the state is read as a field; anything else is a function of the theory. */
  private String function(Result result, String state) {
    String argument = expressions.of(result.argument());
    return fields.contains(result.function())
        ? state + "`" + result.function() + "(" + argument + ")"
        : result.function() + "(" + argument + ", " + state + ")";
  }

  private void addLemma(String name, String claim, String proof) {
    line("");
    line("  " + name + ": LEMMA " + claim);
    line("%|- " + name + " : PROOF " + proof + " QED");
  }

  private static String description(TraceEvent event) {
    String name =
        switch (event) {
          case TraceEvent.Action e -> e.name();
          case TraceEvent.Variable e -> e.name() + " " + e.value();
          case TraceEvent.Fault e -> e.name();
          default -> event.getClass().getSimpleName().toLowerCase(Locale.ROOT);
        };
    double seconds = Time.seconds(event.timeNs());
    String text = String.format(Locale.ROOT, "%.3f s %s: %s", seconds, event.robot(), name);
    return text.length() <= 100 ? text : text.substring(0, 97) + "...";
  }

  /** All constants of a type that occur anywhere, in order. */
  private SortedSet<Comparable<?>> constants(Class<?> type) {
    SortedSet<Comparable<?>> found = new TreeSet<>();
    collect(first, type, found);
    collect(steps, type, found);
    return found;
  }

  private static void collect(Object value, Class<?> type, SortedSet<Comparable<?>> found) {
    if (type.isInstance(value)) {
      found.add((Comparable<?>) value);
      return;
    }
    switch (value) {
      case Iterable<?> values -> values.forEach(each -> collect(each, type, found));
      case Fun<?, ?> fun ->
          fun.forEach((argument, image) -> {
            collect(argument, type, found);
            collect(image, type, found);
          });
      case Term term -> collect(term.args(), type, found);
      case Step step -> {
        collect(step.action(), type, found);
        collect(step.after(), type, found);
        step.results().forEach(result -> collect(result.argument(), type, found));
        step.results().forEach(result -> collect(result.value(), type, found));
      }
      case Record state -> collect(Expressions.components(state), type, found);
      default -> {
        // Holds no constants.
      }
    }
  }

  private void line(String line) {
    text.append(line).append('\n');
  }
}

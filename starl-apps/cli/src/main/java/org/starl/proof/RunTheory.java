package org.starl.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.proof.Expressions.Formal;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Term;
import org.starl.trace.TraceEvent;

/** The run of one instance as a theory: add its steps, then write its text. */
final class RunTheory {

  private static final double NS_PER_S = 1e9;

  /** One step of the automaton. */
  private record Step(TraceEvent event, Action action, Record after, List<Result> results) {}

  /** {@code function(argument, after)} is {@code value}. */
  private record Result(String function, Object argument, Object value) {}

  private final String instance;
  private final String library;
  private final List<Formal> formals;
  private final Record first;
  private final List<Step> steps = new ArrayList<>();
  private final Identifiers identifiers = new Identifiers();
  private final Expressions expressions;

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
    formals.forEach(formal -> identifiers.take(formal.type()));
    for (var component : first.getClass().getRecordComponents()) {
      identifiers.take(component.getName());
    }
  }

  void stepped(TraceEvent event, Action action, Record after) {
    identifiers.take(action.name());
    steps.add(new Step(event, action, after, new ArrayList<>()));
  }

  void resulted(String function, Object argument, Object value) {
    boolean isText = value instanceof String && !expressions.isConstant(value);
    if (!steps.isEmpty() && !isText) {
      steps.get(steps.size() - 1).results().add(new Result(function, argument, value));
    }
  }

  /** {@code run_mutex_crossing}. */
  String name() {
    return "run_" + Identifiers.plain(instance);
  }

  /** The theory's text. */
  String text(String about) {
    StringBuilder text = new StringBuilder();
    line(text, "% " + about + ": " + instance + ", step by step, as a run of " + library + ".");
    line(text, name() + ": THEORY");
    line(text, "BEGIN");
    types(text);
    line(text, "");
    constant(text, 0, first);
    for (int n = 1; n <= steps.size(); n++) {
      Step step = steps.get(n - 1);
      line(text, "");
      line(text, "  % " + described(step.event()));
      line(text, "  a_" + n + ": actions = " + expressions.of(step.action()));
      constant(text, n, step.after());
    }
    begins(text);
    for (int n = 1; n <= steps.size(); n++) {
      step(text, n, steps.get(n - 1));
    }
    line(text, "END " + name());
    return text.toString();
  }

  private void types(StringBuilder text) {
    List<String> actuals = new ArrayList<>();
    for (Formal formal : formals) {
      List<String> names = new ArrayList<>();
      constants(formal.values()).forEach(constant -> names.add(identifiers.of(constant)));
      if (names.isEmpty()) {
        names.add(identifiers.of("no_" + formal.type().toLowerCase(Locale.ROOT)));
      }
      line(text, "  " + formal.type() + ": TYPE = {" + String.join(", ", names) + "}");
      actuals.add(formal.type());
    }
    identifiers
        .all()
        .forEach((thing, name) -> {
          if (!thing.toString().equals(name)) {
            line(text, "  % " + name + " is " + thing);
          }
        });
    line(text, "  IMPORTING " + library + "[" + String.join(", ", actuals) + "]");
  }

  private void constant(StringBuilder text, int n, Record state) {
    line(text, "  s_" + n + ": states =");
    line(text, "    " + expressions.ofState(state));
  }

  private static void begins(StringBuilder text) {
    lemma(text, "begins", "start(s_0)", "(grind)");
    lemma(
        text,
        "reached_0",
        "reachable(s_0)",
        "(then (lemma \"begins\") (lemma \"reachable_start\" (\"s\" \"s_0\")) (assert))");
  }

  private void step(StringBuilder text, int n, Step step) {
    int before = n - 1;
    lemma(
        text,
        "step_" + n,
        "enabled(a_" + n + ", s_" + before + ") AND trans(a_" + n + ", s_" + before + ") = s_" + n,
        proofOfStep(n, step.action()));
    int results = 0;
    for (Result result : step.results()) {
      results++;
      String name = "result_" + n + (results == 1 ? "" : "_" + results);
      String claim = function(result, n) + " = " + expressions.of(result.value());
      lemma(text, name, claim, "(grind-with-ext)");
    }
    lemma(
        text,
        "reached_" + n,
        "reachable(s_" + n + ")",
        "(then (lemma \"reached_"
            + before
            + "\") (lemma \"step_"
            + n
            + "\") (flatten)"
            + (" (lemma \"reachable_step\" (\"s\" \"s_" + before + "\" \"a\" \"a_" + n + "\"))")
            + " (assert))");
  }

  /**
   * Rewriting proves it, unless a step sets a constant function to the value that it has already:
   * then the proof needs a case for the point that is set. The point is the action's first argument
   * of a type parameter; a registration's {@code decide} has none, and adds list {@code number}.
   */
  private String proofOfStep(int n, Action action) {
    String place =
        action.args().stream()
            .filter(arg -> formals.get(0).values().isInstance(arg))
            .map(expressions::of)
            .findFirst()
            .orElse("s_" + n + "`number");
    return "(then (split) (grind-with-ext) (case \"x!1 = " + place + "\") (grind))";
  }

  /** A component of the state is read as a field; anything else is a function of the theory. */
  private String function(Result result, int n) {
    String argument = expressions.of(result.argument());
    boolean isField =
        Arrays.stream(first.getClass().getRecordComponents())
            .anyMatch(component -> component.getName().equals(result.function()));
    return isField
        ? "s_" + n + "`" + result.function() + "(" + argument + ")"
        : result.function() + "(" + argument + ", s_" + n + ")";
  }

  private static void lemma(StringBuilder text, String name, String claim, String proof) {
    line(text, "");
    line(text, "  " + name + ": LEMMA " + claim);
    line(text, "%|- " + name + " : PROOF " + proof + " QED");
  }

  private static String described(TraceEvent event) {
    String what =
        switch (event) {
          case TraceEvent.Action e -> e.name();
          case TraceEvent.Variable e -> e.name() + " " + e.value();
          case TraceEvent.Fault e -> e.name();
          default -> event.getClass().getSimpleName().toLowerCase(Locale.ROOT);
        };
    String text =
        String.format(Locale.ROOT, "%.3f s %s: %s", event.timeNs() / NS_PER_S, event.robot(), what);
    return text.length() <= 100 ? text : text.substring(0, 97) + "...";
  }

  /** All constants of a type that occur anywhere, in order. */
  private SortedSet<Comparable<?>> constants(Class<?> type) {
    Map<Object, Object> found = new LinkedHashMap<>();
    collect(first, type, found);
    for (Step step : steps) {
      collect(step.action(), type, found);
      collect(step.after(), type, found);
      step.results().forEach(result -> collect(result.argument(), type, found));
      step.results().forEach(result -> collect(result.value(), type, found));
    }
    SortedSet<Comparable<?>> sorted = new TreeSet<>();
    found.keySet().forEach(constant -> sorted.add((Comparable<?>) constant));
    return sorted;
  }

  private static void collect(Object value, Class<?> type, Map<Object, Object> found) {
    if (type.isInstance(value)) {
      found.put(value, value);
    } else if (value instanceof Iterable<?> values) {
      values.forEach(each -> collect(each, type, found));
    } else if (value instanceof Fun<?, ?> fun) {
      fun.forEach((argument, image) -> {
        collect(argument, type, found);
        collect(image, type, found);
      });
    } else if (value instanceof Term term) {
      term.args().forEach(arg -> collect(arg, type, found));
    } else if (value instanceof Record state) {
      Expressions.components(state).forEach(each -> collect(each, type, found));
    }
  }

  private static void line(StringBuilder text, String line) {
    text.append(line).append('\n');
  }
}

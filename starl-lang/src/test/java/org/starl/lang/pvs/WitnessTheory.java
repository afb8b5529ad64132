package org.starl.lang.pvs;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/**
 * A theory that each action of an automaton can happen, with two elements of each opaque type; of a
 * program with one zone, since it has many more states.
 */
final class WitnessTheory {

  /** A state that a run reaches, and the step that leads there; the first state has no step. */
  private record Reached(Row state, int before, int action, List<String> arguments) {}

  /** Values of value parameters; others have the first value of their type. */
  private static final Map<String, String> GIVEN =
      Map.of(
          "first", "{bot0, bot1}",
          "before", "[i: PIDS, j: PIDS -> i = bot0 and j = bot1]",
          "near", "[p: Places, q: Places -> true]",
          "way", "[t: Trip -> if t = Trip0 then [] else [A]]",
          "trip", "[i: PIDS -> if i = bot0 then Trip0 else Trip1]");

  /** The same in PVS, and what a component of the first state is. */
  private static final Map<String, String> GIVEN_IN_PVS =
      Map.of(
          "first",
          "add(bot0, singleton(bot1))",
          "before",
          "LAMBDA (i, j: PIDS): i < j",
          "near",
          "constantly[[Places, Places], bool](TRUE)",
          "way",
          "LAMBDA (t: Trip): IF t = Trip0 THEN null[Zones] ELSE cons(A, null) ENDIF",
          "trip",
          "LAMBDA (i: PIDS): IF i = bot0 THEN Trip0 ELSE Trip1 ENDIF",
          "myseq",
          "LAMBDA (i: PIDS): way(trip(i))");

  private final Automaton automaton;
  private final String name;
  private final String source;
  private final Map<String, Integer> sizes = new LinkedHashMap<>();
  private final Machine machine;
  private final List<Reached> states = new ArrayList<>();
  private final Map<Integer, Reached> first = new TreeMap<>();
  private final StringBuilder text = new StringBuilder();

  private WitnessTheory(Automaton automaton, String source) {
    this.automaton = automaton;
    this.source = source;
    name = nameOf(automaton);
    Machine.opaqueTypes(automaton)
        .forEach(type -> sizes.put(type, isProgram() && type.equals("Zones") ? 1 : 2));
    machine = new Machine(automaton, new Sizes(sizes, 2, 2));
  }

  private boolean isProgram() {
    return !automaton.name().endsWith("_decls");
  }

  static String nameOf(Automaton automaton) {
    return automaton.name().replace("_decls", "") + "_witness";
  }

  /**
   * @param source the file of the automaton, as from {@code pvs/}
   * @throws IllegalStateException if an action cannot happen
   */
  static String of(Automaton automaton, String source) throws SourceErrors {
    WitnessTheory theory = new WitnessTheory(automaton, source);
    theory.search();
    return theory.write();
  }

  private Expr given(Field parameter) throws SourceErrors {
    return SourceReader.readExpression(
        automaton,
        machine.elements(),
        parameter.type(),
        parameter.name(),
        GIVEN.get(parameter.name()));
  }

  /** Breadth first, until each action has happened. */
  private void search() throws SourceErrors {
    Set<Row> seen = new LinkedHashSet<>();
    Deque<Integer> open = new ArrayDeque<>();
    Map<String, Object> given = new LinkedHashMap<>();
    for (Field each : machine.parameters()) {
      if (GIVEN.containsKey(each.name())) {
        given.put(each.name(), machine.value(given(each)));
      }
    }
    Row start = machine.starts(given).states().getFirst();
    seen.add(start);
    states.add(new Reached(start, -1, -1, List.of()));
    open.add(0);
    while (first.size() < automaton.actions().size()) {
      Integer number = open.poll();
      if (number == null) {
        throw new IllegalStateException("some action cannot happen: " + first.keySet());
      }
      machine.steps(
          states.get(number).state,
          new Machine.Steps() {
            @Override
            public void step(int action, Object[] arguments, Row after) {
              Reached reached = new Reached(after, number, action, arguments(action, arguments));
              first.putIfAbsent(action, reached);
              if (seen.add(after)) {
                open.add(states.size());
                states.add(reached);
              }
            }
          });
    }
  }

  /** The arguments of {@code release(bot0, {A, B})}, each as text. */
  private List<String> arguments(int action, Object[] arguments) {
    String all = machine.text(action, arguments);
    List<String> texts = new ArrayList<>();
    int depth = 0;
    int begin = automaton.actions().get(action).name().length() + 1;
    for (int i = begin; i < all.length(); i++) {
      char c = all.charAt(i);
      if ((c == ',' && depth == 0) || i == all.length() - 1) {
        texts.add(all.substring(begin, i).strip());
        begin = i + 1;
      }
      depth += "({[".indexOf(c) >= 0 ? 1 : ")}]".indexOf(c) >= 0 ? -1 : 0;
    }
    return arguments.length == 0 ? List.of() : texts;
  }

  private String write() throws SourceErrors {
    text.append(
        "%% Generated by org.starl.lang.pvs from %s, the file to change.\n%%\n".formatted(source));
    text.append(
        "%% Each action of %s can happen: a run leads to a state where it is enabled.\n"
            .formatted(automaton.name()));
    text.append("%s: THEORY\nBEGIN\n".formatted(name));
    Map<String, List<String>> elements = new LinkedHashMap<>();
    for (Field each : machine.elements()) {
      elements.computeIfAbsent(each.type().toString(), any -> new ArrayList<>()).add(each.name());
    }
    elements.forEach((type, names) -> {
      line("%s: TYPE = below(%d)", type, names.size());
      for (int i = 0; i < names.size(); i++) {
        line("%s: %s = %d", names.get(i), type, i);
      }
    });
    line("IMPORTING constantly");
    List<String> actuals = new ArrayList<>(automaton.typeParameters());
    for (Field each : machine.parameters()) {
      String value = GIVEN_IN_PVS.getOrDefault(each.name(), first(each.type()));
      line("%s: %s = %s", each.name(), PvsExpr.type(each.type()), value);
    }
    automaton.valueParameters().forEach(each -> actuals.add(each.name()));
    text.append('\n');
    line("IMPORTING %s[%s]\n", automaton.name(), String.join(", ", actuals));
    String own = automaton.name();
    line("s: VAR %s.states", own);
    line("a: VAR %s.actions\n", own);
    line("run_step: LEMMA reachable(s) AND enabled(a, s) IMPLIES reachable(trans(a, s))");
    text.append(
        "%|- run_step : PROOF\n%|-   (then (skosimp) (expand \"reachable\" +) (flatten) (inst 2 \"s!1\" \"a!1\") (assert))\n%|- QED\n\n");
    line("s0: %s.states =\n    %s\n", own, record(automaton));
    line("at_start: LEMMA start(s0)");
    text.append(
        "%|- at_start : PROOF (then (auto-rewrite \"constantly_at\") (grind :exclude \"constantly\")) QED\n\n");
    line("r0: LEMMA reachable(s0)");
    text.append(
        "%|- r0 : PROOF (then (use \"at_start\") (expand \"reachable\") (flatten)) QED\n\n");
    // A way is a list; the mutex asks whether the set of its zones is empty, or is another set.
    String sets = isProgram() ? " (inst - \"A\") (grind-with-ext)" : "";
    Set<Integer> needed = new java.util.TreeSet<>();
    for (Reached each : first.values()) {
      for (int at = each.before; at > 0; at = states.get(at).before) {
        needed.add(at);
      }
    }
    for (int number : needed) {
      Reached each = states.get(number);
      line("s%d: %s.states = trans(%s, s%d)\n", number, own, action(each), each.before);
      line("r%d: LEMMA reachable(s%d)", number, number);
      text.append(
          """
          %%|- r%d : PROOF
          %%|-   (then (auto-rewrite "constantly_at")
          %%|-     (expand "s%d") (use "run_step") (lemma "r%d") (assert) (hide -1 2)
          %%|-     (grind :exclude "constantly")%s)
          %%|- QED

          """
              .formatted(number, number, each.before, sets));
    }
    for (Map.Entry<Integer, Reached> each : first.entrySet()) {
      String of = automaton.actions().get(each.getKey()).name();
      int at = each.getValue().before;
      line("%s_happens: LEMMA", of);
      line("  reachable(s%d) AND enabled(%s, s%d)", at, action(each.getValue()), at);
      text.append(
          """
          %%|- %s_happens : PROOF
          %%|-   (then (auto-rewrite "constantly_at") (lemma "r%d") (assert) (hide -1)
          %%|-     (grind :exclude "constantly")%s)
          %%|- QED

          """
              .formatted(of, at, sets));
    }
    text.setLength(text.length() - 1);
    return text.append("END ").append(name).append('\n').toString();
  }

  private void line(String format, Object... arguments) {
    text.append("  ").append(format.formatted(arguments)).append('\n');
  }

  private String action(Reached reached) throws SourceErrors {
    Action action = automaton.actions().get(reached.action);
    List<String> all = new ArrayList<>();
    for (int i = 0; i < reached.arguments.size(); i++) {
      all.add(
          new PvsExpr(PvsNames.none(List.of()))
              .of(
                  SourceReader.readExpression(
                      automaton,
                      machine.elements(),
                      action.parameters().get(i).type(),
                      "argument",
                      reached.arguments.get(i)))
              .text(0));
    }
    return action.name() + (all.isEmpty() ? "" : "(" + String.join(", ", all) + ")");
  }

  private String record(Automaton of) {
    return of.state().stream()
        .map(c -> c.name() + " := " + GIVEN_IN_PVS.getOrDefault(c.name(), first(c.type())))
        .collect(java.util.stream.Collectors.joining(",\n       ", "(# ", " #)"));
  }

  /** The first value of a type, which is that of the first start state. */
  private String first(Type type) {
    return switch (type) {
      case Type.Bool bool -> "FALSE";
      case Type.Num num -> "0";
      case Type.Range range -> String.valueOf(range.low());
      case Type.Opaque opaque -> "0";
      case Type.Alias alias -> first(alias.target());
      case Type.Rec rec ->
          rec.fields().stream()
              .map(f -> f.name() + " := " + first(f.type()))
              .collect(java.util.stream.Collectors.joining(", ", "(# ", " #)"));
      case Type.Sum sum -> {
        List<Field> fields = sum.constructors().getFirst().fields();
        yield sum.constructors().getFirst().name()
            + (fields.isEmpty()
                ? ""
                : fields.stream()
                    .map(f -> first(f.type()))
                    .collect(java.util.stream.Collectors.joining(", ", "(", ")")));
      }
      case Type.SetOf set -> "emptyset[%s]".formatted(PvsExpr.type(set.element()));
      case Type.ListOf list -> "null[%s]".formatted(PvsExpr.type(list.element()));
      case Type.OptionOf option -> "bottom";
      case Type.MapOf map ->
          "constantly[%s, %s](%s)"
              .formatted(
                  map.arguments().size() == 1
                      ? PvsExpr.type(map.arguments().getFirst())
                      : "["
                          + String.join(", ", map.arguments().stream().map(PvsExpr::type).toList())
                          + "]",
                  PvsExpr.type(map.result()),
                  first(map.result()));
      case Type.StateOf state -> record(state.automaton());
    };
  }
}

package org.starl.lang.prove;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Automaton.Invariant;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** One question to Z3, for opaque types of one size: are there such states? */
final class Question {

  final Automaton automaton;
  private final Script script = new Script();
  final AutomatonScript machine;
  private final Translator translator;

  /** The parameters of the action, and those for which an invariant fails. */
  private final List<Field> fields = new ArrayList<>();

  private final List<Val> values = new ArrayList<>();
  private final List<String> failsFor = new ArrayList<>();
  private @Nullable Action action;
  private @Nullable Scope parameters;
  private @Nullable Scope after;

  Question(Automaton automaton, int size, String title) {
    this.automaton = automaton;
    String sizes = size == 0 ? "any number of elements" : size + " elements each";
    machine =
        new AutomatonScript(
            automaton,
            new Sorts(automaton, size),
            script,
            automaton.name() + ": " + title + "\nopaque types: " + sizes);
    translator = machine.translator();
  }

  // --- what the states are -----------------------------------------------------------------------

  Question atStart() {
    script.comment("s is a start state");
    automaton.start().forEach(each -> machine.require(each, machine.before));
    return this;
  }

  Question assuming(List<Invariant> invariants) {
    for (Invariant each : invariants) {
      script.comment(each.name() + " holds");
      machine.require(each.condition(), machine.before);
    }
    return this;
  }

  Question enabled(Action of) {
    action = of;
    Scope scope = machine.enabled(of);
    parameters = scope;
    of.parameters().forEach(p -> add(p, scope.variable(p.name())));
    return this;
  }

  /** @param of one that is enabled */
  Question happens(Action of) {
    enabled(of);
    return after(of);
  }

  /** The state after, whether or not the action is enabled. */
  private Question after(Action of) {
    after = machine.after(of, now());
    return this;
  }

  private Scope now() {
    return parameters == null ? machine.before : parameters;
  }

  /** The state that is asked about: the one after the action, if there is one. */
  private Scope asked() {
    return after == null ? machine.before : after;
  }

  private void add(Field field, Val value) {
    fields.add(field);
    values.add(value);
  }

  /** Whether an expression is the same in both states. */
  boolean isUntouched(Expr condition) {
    return after != null
        && translator.bool(condition, machine.before).equals(translator.bool(condition, after));
  }

  // --- what is to fail ---------------------------------------------------------------------------

  /** Says that {@code goal} does not hold: for new symbols, if it is to hold for all values. */
  Question failing(String name, Expr goal) {
    script.comment(name + " does not hold");
    Scope scope = asked();
    Expr left = goal;
    while (true) {
      if (left instanceof Expr.Quantified all && all.forAll()) {
        for (Field each : all.variables()) {
          String symbol =
              "w." + each.name() + (failsFor.contains(each.name()) ? "." + values.size() : "");
          Val value = translator.declare(symbol, each.type());
          scope = scope.with(each.name(), value);
          failsFor.add(each.name());
          add(each, value);
        }
        inductive(all, scope);
        left = all.body();
      } else if (left instanceof Expr.Binary binary && binary.operator() == Operator.IMPLIES) {
        machine.require(binary.left(), scope);
        left = binary.right();
      } else {
        script.require(Smt.not(translator.bool(left, scope)));
        return this;
      }
    }
  }

  /** With recursive functions, the numbers for which a goal fails are taken to be the least ones. */
  private void inductive(Expr.Quantified goal, Scope scope) {
    List<Field> numbers =
        goal.variables().stream().filter(v -> v.type().base() == Type.Num.NAT).toList();
    if (numbers.isEmpty() || !Sorts.isRecursive(automaton)) {
      return;
    }
    script.comment("these are the least numbers");
    script.require(
        translator.quantified(
            true,
            goal.variables(),
            others -> {
              Scope inner = scope;
              for (int i = 0; i < others.size(); i++) {
                inner = inner.with(goal.variables().get(i).name(), others.get(i));
              }
              return Smt.implies(less(numbers, inner, scope), translator.bool(goal.body(), inner));
            }));
  }

  /** That the numbers of one scope are before those of the other, the first ones first. */
  private static String less(List<Field> numbers, Scope one, Scope other) {
    List<String> parts = new ArrayList<>();
    List<String> equal = new ArrayList<>();
    for (Field number : numbers) {
      String a = Val.smt(one.variable(number.name()));
      String b = Val.smt(other.variable(number.name()));
      List<String> all = new ArrayList<>(equal);
      all.add(Smt.call("<", a, b));
      parts.add(Smt.and(all));
      equal.add(Smt.equal(a, b));
    }
    return Smt.or(parts);
  }

  /** What must hold so that an action has an effect wherever it is enabled. */
  List<Obligation> obligations(Action of) {
    action = of;
    script.comment("action " + Shown.head(of));
    Scope scope = machine.declared("a.", of.parameters(), machine.before);
    parameters = scope;
    of.parameters().forEach(p -> add(p, scope.variable(p.name())));
    List<Obligation> all = machine.obligations(of, scope);
    after(of);
    return all;
  }

  /** What must hold so that conditions have values, each where those before it hold. */
  List<Obligation> obligations(List<Expr> conditions) {
    return translator.obligations(() -> translator.all(conditions, machine.before));
  }

  /** What must hold so that a function has a value for all arguments. */
  List<Obligation> obligations(Function function) {
    List<Field> parameters = function.signature().parameters();
    Scope scope = machine.declared("w.", parameters, machine.before);
    return translator.obligations(() ->
        translator.as(
            function.signature().result(),
            function.body(),
            machine.before.only(
                parameters, parameters.stream().map(p -> scope.variable(p.name())).toList())));
  }

  /** Says that one of {@code obligations} does not hold. */
  void failing(List<Obligation> obligations) {
    script.comment("an operation has no value");
    script.require(Smt.not(Smt.and(obligations.stream().map(Obligation::condition).toList())));
  }

  // --- recursive functions -----------------------------------------------------------------------

  /** Says that a call of {@code function} in itself does not make its measure smaller. */
  boolean growing(Function function) {
    Scope scope = machine.declared("w.", function.signature().parameters(), machine.before);
    List<Field> parameters = function.signature().parameters();
    List<Val> here = parameters.stream().map(p -> scope.variable(p.name())).toList();
    Expr measure = function.measure().orElseThrow();
    String now = Val.smt(translator.value(measure, scope));
    List<String> cases = new ArrayList<>();
    for (Translator.RecursiveCall call : translator.callsOfItself(function, machine.before, here)) {
      Scope inner = machine.before.only(parameters, call.arguments());
      String then = Val.smt(translator.value(measure, inner));
      List<String> all = new ArrayList<>(call.path());
      all.add(Smt.not(Smt.and(List.of(Smt.call("<=", "0", then), Smt.call("<", then, now)))));
      cases.add(Smt.quantified(false, call.binders(), Smt.and(all)));
    }
    script.comment(
        "a call of "
            + function.signature().name()
            + " in itself does not make its measure smaller");
    script.require(Smt.or(cases));
    return !cases.isEmpty();
  }

  /**
   * That a function has the same values in both states, as far as it is asked.
   *
   * @param number a parameter of the function
   * @param most a parameter of the action: only for numbers up to it
   */
  record Frame(Function function, String number, String most) {}

  /** Frames that may hold after {@code action}. */
  static List<Frame> frames(Automaton automaton, Action action) {
    List<Frame> all = new ArrayList<>();
    for (Function function : automaton.functions()) {
      if (function.measure().isEmpty() || !function.signature().readsState()) {
        continue;
      }
      all.add(new Frame(function, "", ""));
      for (Field p : function.signature().parameters()) {
        for (Field a : action.parameters()) {
          if (p.type().base() == Type.Num.NAT && a.type().base() == Type.Num.NAT) {
            all.add(new Frame(function, p.name(), a.name()));
          }
        }
      }
    }
    return all;
  }

  /** Says that a frame holds. */
  void require(Frame frame) {
    List<Field> parameters = frame.function().signature().parameters();
    script.comment(
        frame.function().signature().name()
            + " is the same in both states"
            + (frame.number().isEmpty() ? "" : " for " + frame.number() + " <= " + frame.most()));
    script.require(
        translator.quantified(
            true, parameters, v -> Smt.implies(bound(frame, v), same(frame.function(), v))));
  }

  /** Says that it does not, and does for all arguments of a smaller measure. */
  void failing(Frame frame) {
    Function function = frame.function();
    List<Field> parameters = function.signature().parameters();
    Scope scope = machine.declared("w.", parameters, machine.before);
    List<Val> here = parameters.stream().map(p -> scope.variable(p.name())).toList();
    parameters.forEach(p -> add(p, scope.variable(p.name())));
    Expr measure = function.measure().orElseThrow();
    String now = Val.smt(translator.value(measure, scope));
    script.comment(
        "the values of " + function.signature().name() + " differ for the least measure");
    script.require(bound(frame, here));
    script.require(Smt.not(same(function, here)));
    script.require(
        translator.quantified(
            true,
            parameters,
            v -> {
              Scope inner = machine.before.only(parameters, v);
              String then = Val.smt(translator.value(measure, inner));
              return Smt.implies(
                  Smt.and(List.of(Smt.call("<", then, now), bound(frame, v))), same(function, v));
            }));
  }

  private String bound(Frame frame, List<Val> arguments) {
    List<Field> parameters = frame.function().signature().parameters();
    for (int i = 0; i < parameters.size(); i++) {
      if (parameters.get(i).name().equals(frame.number())) {
        String most = Val.smt(now().variable(frame.most()));
        return Smt.call("<=", Val.smt(arguments.get(i)), most);
      }
    }
    return Smt.TRUE;
  }

  private String same(Function function, List<Val> arguments) {
    return translator.equal(
        function.signature().result(),
        translator.applied(function, machine.before, arguments),
        translator.applied(function, asked(), arguments));
  }

  // --- answers -----------------------------------------------------------------------------------

  boolean isApproximate() {
    return translator.isApproximate();
  }

  /** What Z3 is asked. */
  Script script() {
    translator.unfold(fields, values);
    return script;
  }

  /** The states that Z3 has found, line by line. */
  List<String> shown(Solver solver) {
    Shown shown = new Shown(translator, solver);
    shown.minimise(fields, values, machine.before);
    if (!solver.hasModel()) {
      return List.of("the states that Z3 found could not be made small within the limit");
    }
    List<String> lines = new ArrayList<>();
    if (!automaton.numbers().isEmpty()) {
      lines.add(
          automaton.numbers().stream()
              .map(name -> name + " = " + solver.number("p." + name))
              .collect(Collectors.joining(", ", "with    ", "")));
    }
    List<String> unusual = shown.unusual(machine.before);
    String state = action == null ? "state " : "before";
    lines.add(
        state + "  " + (unusual.isEmpty() ? "all empty, 0 or none" : String.join(", ", unusual)));
    int own = action == null ? 0 : action.parameters().size();
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < fields.size(); i++) {
      texts.add(shown.text(fields.get(i).type(), values.get(i)));
    }
    if (action != null) {
      lines.add("action  " + action.name() + "(" + String.join(", ", texts.subList(0, own)) + ")");
    }
    if (after != null) {
      List<String> changed = shown.changed(machine.before, after);
      lines.add("after   " + (changed.isEmpty() ? "the same" : String.join(", ", changed)));
    }
    if (!failsFor.isEmpty()) {
      List<String> all = new ArrayList<>();
      for (int i = 0; i < failsFor.size(); i++) {
        all.add(failsFor.get(i) + " = " + texts.get(own + i));
      }
      lines.add("fails   for " + String.join(", ", all));
    }
    return lines;
  }
}

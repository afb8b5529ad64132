package org.starl.lang.java;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.lang.java.RandomAutomataTest.Call;
import org.starl.lang.java.RandomAutomataTest.Steps;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;

/** The theory of a random automaton, with a claim for each action in each state of a run. */
final class RandomTheory {

  private final String name;
  private final Automaton automaton;
  private final List<String> claims = new ArrayList<>();
  private final StringBuilder text = new StringBuilder();
  private int states;

  RandomTheory(String name, Automaton automaton) {
    this.name = name;
    this.automaton = automaton;
  }

  /** What Java makes of each call in a state. */
  void add(Object state, Steps steps) {
    String at = "s_" + states;
    text.append("  %s: states =\n    %s\n\n".formatted(at, state(state)));
    for (int action = 0; action < automaton.actions().size(); action++) {
      List<String> all = new ArrayList<>();
      for (int i = 0; i < steps.enabled().size(); i++) {
        if (steps.enabled().get(i).action() == action) {
          String call = call(steps.enabled().get(i));
          all.add("enabled(%s, %s)".formatted(call, at));
          all.add("same(trans(%s, %s),\n      %s)".formatted(call, at, state(steps.java().get(i))));
        }
      }
      for (Call each : steps.disabled()) {
        if (each.action() == action) {
          all.add("NOT enabled(%s, %s)".formatted(call(each), at));
        }
      }
      if (!all.isEmpty()) {
        String claim = "claim_%d_%d".formatted(states, action);
        claims.add(claim);
        text.append("  %s: bool =\n    %s\n\n".formatted(claim, String.join(" AND\n    ", all)));
      }
    }
    states++;
  }

  List<String> claims() {
    return claims;
  }

  /** PVS evaluates no quantifier over a parameter: here its ids are declared. */
  String text() {
    String theory = PvsTheory.of(automaton, "a random source");
    String head = automaton.name() + " [ T: TYPE ]: THEORY\nBEGIN\n";
    String ids = String.join(", ", RandomAutomataTest.IDS);
    if (!theory.contains(head)) {
      throw new AssertionError(theory);
    }
    return theory
        .replace(head, name + ": THEORY\nBEGIN\n  T: TYPE = {" + ids + "}\n\n")
        .replace("END " + automaton.name() + "\n", "\n" + same() + text + "END " + name + "\n");
  }

  /** PVS evaluates neither the equality of functions in records nor that of lists. */
  private String same() {
    String parts =
        automaton.state().stream()
            .map(each -> same("s1`" + each.name(), "s2`" + each.name(), each.type()))
            .collect(Collectors.joining(" AND\n    "));
    return "  same(s1, s2: states): bool =\n    %s\n\n".formatted(parts);
  }

  private static String same(String one, String other, Type type) {
    return switch (type) {
      case Type.SetOf set -> "(FORALL (x: T): %s(x) = %s(x))".formatted(one, other);
      case Type.MapOf map ->
          "(FORALL (y: T): %s)".formatted(same(one + "(y)", other + "(y)", map.result()));
      case Type.ListOf list ->
          "length(%1$s) = length(%2$s) AND (FORALL (k: below(length(%1$s))): nth(%1$s, k) = nth(%2$s, k))"
              .formatted(one, other);
      default -> one + " = " + other;
    };
  }

  private static String call(Call call) {
    return "act%d(%s, %s, %s)"
        .formatted(call.action(), call.java()[0], call.java()[1], call.java()[2]);
  }

  private String state(Object state) {
    return record(
        automaton.state().stream()
            .map(each -> assigned(each.name(), each.type(), state))
            .collect(Collectors.joining(",\n       ")));
  }

  private static String record(String fields) {
    return "(# " + fields + " #)";
  }

  private static String assigned(String name, Type type, Object of) {
    return name + " := " + value(type, RandomAutomataTest.field(of, name));
  }

  @SuppressWarnings("unchecked") // all maps are of ids
  private static String value(Type type, Object value) {
    return switch (type) {
      case Type.Bool bool -> value.equals(true) ? "TRUE" : "FALSE";
      case Type.SetOf set -> {
        Collection<?> all = (Collection<?>) value;
        yield all.isEmpty()
            ? "emptyset[T]"
            : all.stream()
                .map(each -> "x = " + each)
                .collect(Collectors.joining(" OR ", "{x: T | ", "}"));
      }
      case Type.ListOf list -> {
        Collection<?> all = (Collection<?>) value;
        yield all.isEmpty()
            ? "null[T]"
            : all.stream().map(Object::toString).collect(Collectors.joining(", ", "(: ", " :)"));
      }
      case Type.OptionOf option ->
          value instanceof Lift.up<?> up
              ? "up(" + value(option.element(), up.value()) + ")"
              : "bottom";
      case Type.MapOf map -> {
        List<String> ids = RandomAutomataTest.IDS;
        StringBuilder cases = new StringBuilder("LAMBDA (y: T): ");
        for (String id : ids.subList(1, ids.size())) {
          String at = value(map.result(), ((Fun<String, ?>) value).at(id));
          cases.append("IF y = %s THEN %s ELSE ".formatted(id, at));
        }
        cases.append(value(map.result(), ((Fun<String, ?>) value).at(ids.getFirst())));
        yield cases.append(" ENDIF".repeat(ids.size() - 1)).toString();
      }
      case Type.Rec rec ->
          record(
              rec.fields().stream()
                  .map(each -> assigned(each.name(), each.type(), value))
                  .collect(Collectors.joining(", ")));
      default -> RandomAutomataTest.text(type, value);
    };
  }
}

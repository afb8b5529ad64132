package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Refinement;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/** Reads what an automaton refines, after its actions. */
record RefinementReader(PartsReader reader, List<Action> actions) {

  /** @param of the abstract automaton */
  Refinement read(StarlParser.RefinesPartContext at, Automaton of) {
    String name = reader.newName(at.name);
    reader.scope.knowTypes(of);
    Map<String, Expr> given = new LinkedHashMap<>();
    reader.each(at.mapping(), StarlParser.MappedContext.class, each -> value(each, of, given));
    Map<String, List<Effect.Step>> steps = new LinkedHashMap<>();
    reader.each(
        at.mapping(), StarlParser.StepOfContext.class, each -> steps(each, name, of, steps));
    Map<String, Expr> values = new LinkedHashMap<>();
    boolean isRight = reader.problems.isEmpty();
    Refinement.paths(of)
        .forEach((path, type) -> {
          Expr value = given.get(path);
          if (value != null) {
            values.put(path, value);
          } else if (isRight) { // else its value may be what is wrong
            reader.problems.add(
                at,
                "'%s' of %s has no value; expected '%s := ...', of type %s"
                    .formatted(path, of.name(), path, type));
          }
        });
    return new Refinement(
        name, of, Collections.unmodifiableMap(values), Collections.unmodifiableMap(steps), pos(at));
  }

  // --- the abstract state

  private void value(StarlParser.MappedContext at, Automaton of, Map<String, Expr> values) {
    StringBuilder path = new StringBuilder(at.name.getText());
    Type type = component(at.name, of);
    for (StarlParser.IdContext part : at.path) {
      if (!(type instanceof Type.StateOf used)) {
        throw reader.expressions.wrong(
            part, "'" + path + "' of " + of.name() + " is no used automaton; expected ':='");
      }
      type = component(part, used.automaton());
      path.append('.').append(part.getText());
    }
    Expr value = reader.expressions.read(at.expression(), type);
    put(at, path.toString(), type, value, values);
  }

  private Type component(StarlParser.IdContext at, Automaton of) {
    List<String> known = of.state().stream().map(Automaton.Component::name).toList();
    if (!known.contains(at.getText())) {
      throw reader.expressions.wrong(
          at,
          "'%s' is no component of %s; %s"
              .formatted(at.getText(), of.name(), Problems.oneOf(at.getText(), known)));
    }
    return of.component(at.getText()).orElseThrow().type();
  }

  /** A whole state of a used automaton is the values of its components. */
  private void put(
      StarlParser.MappedContext at, String path, Type type, Expr value, Map<String, Expr> values) {
    if (type instanceof Type.StateOf used) {
      for (Automaton.Component each : used.automaton().state()) {
        Expr part = new Expr.Get(value, each.name(), each.type(), value.pos());
        put(at, path + "." + each.name(), each.type(), part, values);
      }
    } else if (values.put(path, value) != null) {
      reader.problems.add(at, "'" + path + "' has two values; expected one");
    }
  }

  // --- the abstract steps

  private void steps(
      StarlParser.StepOfContext at,
      String name,
      Automaton of,
      Map<String, List<Effect.Step>> steps) {
    String own = at.action.getText();
    Action action =
        actions.stream()
            .filter(each -> each.name().equals(own))
            .findFirst()
            .orElseThrow(() ->
                reader.expressions.wrong(
                    at.action,
                    "'%s' is no action of %s; %s"
                        .formatted(
                            own,
                            reader.scope.automaton,
                            Problems.oneOf(own, actions.stream().map(Action::name).toList()))));
    List<String> given = at.own.stream().map(StarlParser.IdContext::getText).toList();
    List<String> wanted = action.parameters().stream().map(Field::name).toList();
    if (!given.equals(wanted)) {
      throw reader.expressions.wrong(
          at.action,
          "'%s' has other parameters; expected %s"
              .formatted(
                  own, wanted.isEmpty() ? own : own + "(" + String.join(", ", wanted) + ")"));
    }
    List<Effect.Step> all = new ArrayList<>();
    reader.scope.push(action.parameters());
    try {
      read(at.step(), null, name, of, all);
    } finally {
      reader.scope.pop(action.parameters());
    }
    if (steps.put(own, List.copyOf(all)) != null) {
      reader.problems.add(at, "'" + own + "' is here twice; expected one line for it");
    }
  }

  /** @param when the conditions on the way to {@code at}; null if there are none */
  private void read(
      StarlParser.StepContext at,
      @Nullable Expr when,
      String name,
      Automaton of,
      List<Effect.Step> steps) {
    switch (at) {
      case StarlParser.OneStepContext one -> {
        Action action = reader.action(one.action, of);
        List<Expr> arguments =
            reader.expressions.arguments(
                action.name(),
                action.parameters(),
                one.arguments() == null ? List.of() : one.arguments().expression(),
                one);
        steps.add(
            new Effect.Step(Optional.ofNullable(when), name, of, action, arguments, pos(one)));
      }
      case StarlParser.StepIfContext choice -> {
        Expr condition = reader.expressions.bool(choice.expression());
        read(choice.step(0), and(when, condition), name, of, steps);
        if (choice.step().size() > 1) {
          Expr not = new Expr.Not(condition, condition.pos());
          read(choice.step(1), and(when, not), name, of, steps);
        }
      }
      default -> {
        // 'nothing'
      }
    }
  }

  private static Expr and(@Nullable Expr first, Expr then) {
    return first == null
        ? then
        : new Expr.Binary(Operator.AND, first, then, Type.Bool.BOOL, then.pos());
  }
}

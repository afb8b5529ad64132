package org.starl.lang.tree;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.starl.lang.tree.Type.Field;

/** Puts an expression of a used automaton's source into the user's. */
public final class Lifting {

  private final String used;
  private final Automaton automaton;
  private final Expr state;
  private final Pos pos;
  private final Map<String, Expr> values = new LinkedHashMap<>();

  /**
   * @param used the component of the used automaton
   * @param pos where errors are in the user's source
   */
  public Lifting(String used, Automaton automaton, Pos pos) {
    this(used, automaton, new Expr.Component(used, new Type.StateOf(automaton), pos), pos);
  }

  private Lifting(String used, Automaton automaton, Expr state, Pos pos) {
    this.used = used;
    this.automaton = automaton;
    this.state = state;
    this.pos = pos;
  }

  /** The same with values, of the user's source, in the place of variables. */
  public Lifting with(List<Field> parameters, List<Expr> arguments) {
    Lifting lifting = new Lifting(used, automaton, state, pos);
    for (int i = 0; i < arguments.size(); i++) {
      lifting.values.put(parameters.get(i).name(), arguments.get(i));
    }
    return lifting;
  }

  /** For expressions of an automaton that the used one uses. */
  public Lifting inside(String component) {
    Automaton inner = Objects.requireNonNull(automaton.uses().get(component), component);
    Expr cell = new Expr.Get(state, component, new Type.StateOf(inner), pos);
    return new Lifting("", inner, cell, pos);
  }

  /** {@code expr}, of the user's state. */
  public Expr lift(Expr expr) {
    return new Substitution().replace(lifted(expr), values);
  }

  private Expr lifted(Expr expr) {
    return switch (expr) {
      case Expr.Component component -> new Expr.Get(state, component.name(), component.type(), pos);
      case Expr.Call call -> call(call);
      case Expr.Enabled step -> {
        List<Expr> arguments = step.arguments().stream().map(this::lifted).toList();
        Lifting to = inside(step.used()).with(step.action().parameters(), arguments);
        yield Exprs.all(
            step.action().pre().stream().map(each -> to.lift(each.condition())).toList(), pos);
      }
      case Expr.Started started -> {
        Lifting to = inside(started.used());
        yield Exprs.all(started.automaton().start().stream().map(to::lift).toList(), pos);
      }
      default -> Exprs.rebuild(expr, pos, this::lifted);
    };
  }

  /** Functions of what is used twice removed have no name in the user's source. */
  private Expr call(Expr.Call call) {
    List<Expr> arguments = call.arguments().stream().map(this::lifted).toList();
    if (call.used().isEmpty() && !used.isEmpty()) {
      return new Expr.Call(used, call.function(), arguments, pos);
    }
    Lifting to = call.used().isEmpty() ? this : inside(call.used());
    Function function = to.automaton.function(call.function().name()).orElseThrow();
    if (function.measure().isPresent()) {
      throw new IllegalArgumentException(
          function.signature().name() + " calls itself; expected no such function here");
    }
    return to.with(function.signature().parameters(), arguments).lift(function.body());
  }
}

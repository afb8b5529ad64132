package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.tree.Type.Field;

/** Puts values in the place of variables; bound variables get names of their own. Not thread-safe. */
public final class Substitution {

  private int renamed;

  /** The body of {@code function} of these arguments. */
  public Expr of(Function function, List<Expr> arguments) {
    Map<String, Expr> values = new LinkedHashMap<>();
    for (int i = 0; i < arguments.size(); i++) {
      values.put(function.signature().parameters().get(i).name(), arguments.get(i));
    }
    return replace(function.body(), values);
  }

  /** {@code at} with these values in the place of its free variables. */
  public Expr replace(Expr at, Map<String, Expr> values) {
    return switch (at) {
      case Expr.Variable v -> values.getOrDefault(v.name(), v);
      case Expr.Quantified q -> {
        Bound bound = new Bound(q.variables(), values, q.pos());
        yield new Expr.Quantified(
            q.forAll(), bound.fields, replace(q.body(), bound.values), q.pos());
      }
      case Expr.SuchThat set -> {
        Bound bound = new Bound(List.of(set.variable()), values, set.pos());
        yield new Expr.SuchThat(
            bound.fields.getFirst(), replace(set.body(), bound.values), set.type(), set.pos());
      }
      case Expr.MapOf map -> {
        Bound bound = new Bound(map.variables(), values, map.pos());
        yield new Expr.MapOf(
            bound.fields, replace(map.body(), bound.values), map.type(), map.pos());
      }
      case Expr.Match match -> {
        List<Expr.Case> cases = new ArrayList<>();
        for (Expr.Case each : match.cases()) {
          Bound bound = new Bound(each.variables(), values, match.pos());
          cases.add(
              new Expr.Case(each.constructor(), bound.fields, replace(each.value(), bound.values)));
        }
        yield new Expr.Match(
            replace(match.of(), values), List.copyOf(cases), match.type(), match.pos());
      }
      default -> Exprs.rebuild(at, child -> replace(child, values));
    };
  }

  /** Variables with new names, if an old one is free in a value. */
  private final class Bound {
    private final List<Field> fields = new ArrayList<>();
    private final Map<String, Expr> values;

    private Bound(List<Field> variables, Map<String, Expr> outer, Pos pos) {
      values = new LinkedHashMap<>(outer);
      for (Field variable : variables) {
        String name = variable.name();
        values.remove(name);
        boolean isTaken = outer.values().stream().anyMatch(value -> Exprs.mentions(value, name));
        Field now = isTaken ? new Field(name + "_" + ++renamed, variable.type()) : variable;
        if (isTaken) {
          values.put(name, new Expr.Variable(now.name(), now.type(), pos));
        }
        fields.add(now);
      }
    }
  }
}

package org.starl.lang.java;

import java.util.ArrayList;
import java.util.List;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Type.Field;

/**
 * The values that make a condition false, as text: {@code "req_set(" + i + ") = " + s.req_set.at(i)}.
 * Functions are read as their bodies, and a false {@code forall} gives the first value that breaks it.
 */
record Values(ExpressionWriter writer) {

  /**
   * A value in a condition.
   *
   * @param isVariable whether the name of an action's step tells it already
   */
  private record Value(Code text, boolean isVariable) {}

  /** The text for a false condition. */
  Code of(Expr condition) {
    return joined(why(condition, false));
  }

  private static Code joined(List<Value> values) {
    boolean hasMore = values.stream().anyMatch(value -> !value.isVariable);
    Code whole = null;
    List<Code> known = new ArrayList<>();
    for (Value value : values) {
      if ((!hasMore || !value.isVariable) && !known.contains(value.text)) {
        known.add(value.text);
        whole = whole == null ? value.text : concat(concat(whole, Code.string(", ")), value.text);
      }
    }
    return whole == null ? Code.string("") : whole;
  }

  /** Values that make {@code at} be {@code is}. */
  private List<Value> why(Expr at, boolean is) {
    return switch (at) {
      case Expr.Not not -> why(not.of(), !is);
      case Expr.Binary e
          when (e.operator() == Operator.AND && !is) || (e.operator() == Operator.OR && is) ->
          either(e.left(), e.right(), is);
      case Expr.Binary e when e.operator() == Operator.AND || e.operator() == Operator.OR -> {
        List<Value> both = new ArrayList<>(why(e.left(), is));
        both.addAll(why(e.right(), is));
        yield both;
      }
      case Expr.Binary e when e.operator() == Operator.IMPLIES && !is -> {
        List<Value> both = new ArrayList<>(why(e.left(), true));
        both.addAll(why(e.right(), false));
        yield both;
      }
      case Expr.Quantified e when e.forAll() && !is ->
          writer
              .finite()
              .counterexample(e, body -> named(e.variables().getFirst(), of(body)))
              .map(text -> List.of(new Value(text, false)))
              .orElse(List.of());
      case Expr.Quantified e -> List.of();
      case Expr.If e ->
          List.of(
              new Value(
                  Code.choice(
                      writer.of(e.condition()),
                      joined(why(e.then(), is)),
                      joined(why(e.otherwise(), is))),
                  false));
      case Expr.Match e ->
          List.of(new Value(Choices.of(e, writer, each -> inCase(e, each, is)), false));
      case Expr.Enabled e when !is && writer.canAsk(e) ->
          List.of(new Value(writer.enabled(e).then("falseConjunct"), false));
      case Expr.Call e when writer.canInline(e) -> why(writer.inlining().body(e), is);
      default -> {
        List<Value> values = new ArrayList<>();
        collect(at, values);
        yield values;
      }
    };
  }

  /** With the value of {@code variable}, if the text does not have it. */
  private static Code named(Field variable, Code text) {
    Code value = Code.name(JavaTypes.variable(variable.name()));
    if (text instanceof Code.Message message && message.parts().contains(value)) {
      return text;
    }
    Code name = concat(Code.string(variable.name().replaceAll("_\\d+$", "") + " = "), value);
    return concat(concat(name, Code.string(", ")), text);
  }

  /** A case that is the constant itself is explained by the value that was matched. */
  private Code inCase(Expr.Match match, Expr value, boolean is) {
    return joined(why(value instanceof Expr.Bool ? match.of() : value, is));
  }

  /** The values of the first side that is {@code is}; of both, if they are the same ones. */
  private List<Value> either(Expr left, Expr right, boolean is) {
    List<Value> first = why(left, is);
    List<Value> second = why(right, is);
    if (first.equals(second) || second.isEmpty()) {
      return first;
    }
    Code condition = writer.of(left);
    Code text = Code.choice(is ? condition : Code.not(condition), joined(first), joined(second));
    boolean areVariables =
        first.stream().allMatch(Value::isVariable) && second.stream().allMatch(Value::isVariable);
    return List.of(new Value(text, areVariables));
  }

  /** Adds what is read from the state; also variables. */
  private void collect(Expr at, List<Value> values) {
    boolean isGiven = at instanceof Expr.At e && e.map() instanceof Expr.Parameter;
    boolean isRead =
        at instanceof Expr.Component
            || at instanceof Expr.Parameter
            || (at instanceof Expr.At && !isGiven)
            || at instanceof Expr.Get
            || at instanceof Expr.Call;
    if (isRead || at instanceof Expr.Variable) {
      Code text = concat(concat(name(at), Code.string(" = ")), writer.of(at));
      values.add(new Value(text, at instanceof Expr.Variable));
    } else if (isGiven) {
      ((Expr.At) at).arguments().forEach(argument -> collect(argument, values));
    } else if (!(at instanceof Expr.Quantified
        || at instanceof Expr.SuchThat
        || at instanceof Expr.MapOf)) {
      Exprs.parts(at).forEach(part -> collect(part, values));
    }
  }

  /** How a value is called: {@code held(bot1)}. */
  private Code name(Expr at) {
    return switch (at) {
      case Expr.Component e -> Code.string(e.name());
      case Expr.Parameter e -> Code.string(e.name());
      case Expr.Variable e -> Code.string(e.name().replaceAll("_\\d+$", ""));
      case Expr.At e -> applied(name(e.map()), e.arguments());
      case Expr.Call e -> applied(Code.string(e.function().name()), e.arguments());
      case Expr.Get e -> concat(name(e.of()), Code.string("." + e.field()));
      default -> shown(at);
    };
  }

  private Code applied(Code function, List<Expr> arguments) {
    if (arguments.isEmpty()) {
      return function;
    }
    Code text = concat(function, Code.string("("));
    for (int i = 0; i < arguments.size(); i++) {
      text = i == 0 ? text : concat(text, Code.string(", "));
      text = concat(text, shown(arguments.get(i)));
    }
    return concat(text, Code.string(")"));
  }

  private Code shown(Expr at) {
    if (at instanceof Expr.Numeral number) {
      return Code.string(number.value().toPlainString());
    }
    return writer.of(at);
  }

  /** {@code a}, then {@code b}, in one text. */
  private static Code concat(Code a, Code b) {
    return Code.message(a, b);
  }
}

package org.starl.lang.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Pos;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Field;

/**
 * Evaluates conditions on all values of a type. Either they can be true, or false, only of the
 * elements of finite sets; or they are evaluated at each value that they distinguish, and once for
 * all others.
 */
final class Finite {

  private final ExpressionWriter writer;
  // What holds where the source evaluates the part that is looked at.
  private final List<Code> guards = new ArrayList<>();

  Finite(ExpressionWriter writer) {
    this.writer = writer;
  }

  private String quantifiers() {
    return writer.types().use("org.starl.spec.automaton.Finite");
  }

  Code quantified(Expr.Quantified at) {
    Field variable = at.variables().getFirst();
    Expr body = rest(at);
    Where where = where(variable, body, !at.forAll());
    Code here = writer.under(variable, () -> writer.of(body));
    Code values = null;
    if (where.sets.isEmpty()) {
      values = at.forAll() ? Code.Text.TRUE : Code.Text.FALSE;
    } else {
      String function = quantifiers() + (at.forAll() ? ".forAll" : ".exists");
      values = Code.call(function, where.with(lambda(variable, here)));
    }
    return at.forAll() ? Code.and(values, where.elsewhere) : Code.or(values, where.elsewhere);
  }

  /** A value of which the condition is false, and the text of it: for messages. */
  Optional<Code> counterexample(Expr.Quantified at, Function<Expr, Code> text) {
    Field variable = at.variables().getFirst();
    Expr body = rest(at);
    Where where = where(variable, body, false);
    if (where.sets.isEmpty()) {
      return Optional.empty();
    }
    Code fails = writer.under(variable, () -> Code.not(writer.of(body)));
    Code value = writer.under(variable, () -> text.apply(body));
    List<Code> arguments = new ArrayList<>();
    arguments.add(lambda(variable, fails));
    arguments.add(lambda(variable, value));
    arguments.addAll(where.sets);
    return Optional.of(Code.call(quantifiers() + ".first", arguments.toArray(Code[]::new)));
  }

  /** The body, with a quantifier over the variables after the first. */
  private static Expr rest(Expr.Quantified at) {
    return at.variables().size() == 1
        ? at.body()
        : new Expr.Quantified(
            at.forAll(), at.variables().subList(1, at.variables().size()), at.body(), at.pos());
  }

  Code set(Expr.SuchThat at) {
    Where where = where(at.variable(), at.body(), true);
    Code here = writer.under(at.variable(), () -> writer.of(at.body()));
    if (writer.types().form(at.type()) == JavaTypes.Sets.FUN) {
      return map(
          new Where(where.sets, writer.types().always(where.elsewhere)),
          () -> lambda(at.variable(), here));
    }
    if (!where.elsewhere.equals(Code.Text.FALSE)) {
      throw new NotExecutable(
          at.pos(),
          "this set may be infinite; expected a condition on finitely many values, or a line: java "
              + at.type()
              + " = \"org.starl.spec.automaton.Fun\"");
    }
    return where.sets.isEmpty()
        ? writer.types().emptyset()
        : Code.call(quantifiers() + ".suchThat", where.with(lambda(at.variable(), here)));
  }

  Code map(Expr.MapOf at) {
    Field variable = at.variables().getFirst();
    Expr body =
        at.variables().size() == 1
            ? at.body()
            : new Expr.MapOf(
                at.variables().subList(1, at.variables().size()),
                at.body(),
                curried((Type.MapOf) at.type().base()),
                at.pos());
    Where where = changes(variable, body);
    Code all = writer.types().all(variable.type(), at.pos());
    if (where == null && all != null) {
      // What it is elsewhere is the same for all maps of the type.
      Code any = writer.types().any(body.type(), at.pos());
      where = new Where(List.of(all), writer.types().always(any));
    } else if (where == null) {
      Code elsewhere = writer.elsewhere(variable, () -> writer.of(body));
      where = new Where(sets(variable, body), writer.types().always(elsewhere));
    }
    return map(where, () -> lambda(variable, writer.under(variable, () -> writer.of(body))));
  }

  /** The map that is {@code function} at each value of the variable. */
  Code each(Field variable, Code function, Type result, Pos pos) {
    Code all = writer.types().all(variable.type(), pos);
    return all == null
        ? Code.call(writer.types().use("org.starl.spec.automaton.Fun") + ".of", function)
        : map(
            new Where(List.of(all), writer.types().always(writer.types().any(result, pos))),
            () -> function);
  }

  /** The map that is {@code function} at the sets, and else that of {@code where}. */
  private Code map(Where where, Supplier<Code> function) {
    if (where.sets.isEmpty()) {
      return where.elsewhere;
    }
    List<Code> all = new ArrayList<>(List.of(where.elsewhere, function.get()));
    all.addAll(where.sets);
    return Code.call(quantifiers() + ".map", all.toArray(Code[]::new));
  }

  /** Of {@code if condition then value else other(variable)}: where the condition may be true. */
  private @Nullable Where changes(Field variable, Expr body) {
    if (!(body instanceof Expr.If choice
        && choice.otherwise() instanceof Expr.At other
        && other.arguments().size() == 1
        && isVariable(other.arguments().getFirst(), variable.name())
        && !(other.map() instanceof Expr.Parameter)
        && !Exprs.mentions(other.map(), variable.name()))) {
      return null;
    }
    List<Code> bounds = bounds(variable.name(), choice.condition(), true);
    return bounds == null ? null : new Where(bounds, writer.of(other.map()));
  }

  private static Type curried(Type.MapOf map) {
    return new Type.MapOf(map.arguments().subList(1, map.arguments().size()), map.result());
  }

  private static Code lambda(Field variable, Code body) {
    return new Code.Lambda(JavaTypes.variable(variable.name()), body);
  }

  /**
   * Where a condition is to be evaluated.
   *
   * @param sets of values
   * @param elsewhere its value at all others
   */
  private record Where(List<Code> sets, Code elsewhere) {
    private Code[] with(Code lambda) {
      List<Code> all = new ArrayList<>(List.of(lambda));
      all.addAll(sets);
      return all.toArray(Code[]::new);
    }
  }

  /** Where {@code body} is to be evaluated to find the values of which it is {@code wanted}. */
  private Where where(Field variable, Expr body, boolean wanted) {
    Code all = writer.types().all(variable.type(), body.pos());
    if (all != null) {
      return new Where(List.of(all), wanted ? Code.Text.FALSE : Code.Text.TRUE);
    }
    List<Code> bounds = bounds(variable.name(), body, wanted);
    if (bounds != null) {
      return new Where(bounds, wanted ? Code.Text.FALSE : Code.Text.TRUE);
    }
    return new Where(sets(variable, body), writer.elsewhere(variable, () -> writer.of(body)));
  }

  /** Finite sets that have all values of which {@code at} is {@code wanted}; null if none is known. */
  private @Nullable List<Code> bounds(String variable, Expr at, boolean wanted) {
    return switch (at) {
      case Expr.Not not -> bounds(variable, not.of(), !wanted);
      case Expr.Call call when Exprs.mentions(call, variable) ->
          bounds(variable, writer.inlining().body(call), wanted);
      case Expr.Enabled step when Exprs.mentions(step, variable) ->
          bounds(variable, writer.inlining().condition(step), wanted);
      case Expr.Bool constant when constant.value() != wanted -> List.of();
      case Expr.Binary e ->
          switch (e.operator()) {
            case AND -> both(variable, e, wanted, wanted, wanted);
            case OR -> both(variable, e, wanted, wanted, !wanted);
            case IMPLIES -> both(variable, e, !wanted, wanted, !wanted);
            case EQUAL -> wanted ? equal(variable, e) : null;
            case UNEQUAL -> wanted ? null : equal(variable, e);
            case IN -> wanted ? elements(variable, e) : null;
            default -> null;
          };
      default -> null;
    };
  }

  /** Of two conditions: a bound of one if both must hold, else the bounds of both. */
  private @Nullable List<Code> both(
      String variable, Expr.Binary of, boolean leftWanted, boolean rightWanted, boolean mustBoth) {
    if (mustBoth && leftWanted && rightWanted && isRange(of, variable)) {
      Expr from = ((Expr.Binary) of.left()).left();
      Expr to = ((Expr.Binary) of.right()).right();
      Expr number = ((Expr.Binary) of.left()).right();
      Code range = Code.call(quantifiers() + ".range", writer.of(from), writer.of(to));
      return List.of(tried(List.of(from, to), within(number, from.type(), range)));
    }
    List<Code> left = bounds(variable, of.left(), leftWanted);
    if (mustBoth && left != null) {
      return left;
    }
    List<Code> right = afterLeft(variable, of, () -> bounds(variable, of.right(), rightWanted));
    if (mustBoth) {
      return right;
    }
    if (left == null || right == null) {
      return null;
    }
    return joined(left, right);
  }

  /** Whether {@code at} is {@code a <= variable and variable <= b}, of whole numbers. */
  private static boolean isRange(Expr.Binary at, String variable) {
    return at.left() instanceof Expr.Binary low
        && at.right() instanceof Expr.Binary high
        && low.operator() == Operator.AT_MOST
        && high.operator() == Operator.AT_MOST
        && isVariable(low.right(), variable)
        && isVariable(high.left(), variable)
        && Type.isNumber(low.right().type(), Type.Num::isWhole)
        && Type.isNumber(low.left().type(), Type.Num::isWhole)
        && Type.isNumber(high.right().type(), Type.Num::isWhole)
        && !Exprs.mentions(low.left(), variable)
        && !Exprs.mentions(high.right(), variable);
  }

  private static List<Code> joined(List<Code> left, List<Code> right) {
    List<Code> all = new ArrayList<>(left);
    right.stream().filter(each -> !all.contains(each)).forEach(all::add);
    return all;
  }

  private @Nullable List<Code> equal(String variable, Expr.Binary at) {
    boolean isLeft = isVariable(at.left(), variable);
    Expr one = isLeft ? at.left() : at.right();
    Expr other = isLeft ? at.right() : at.left();
    return isVariable(one, variable) && !Exprs.mentions(other, variable)
        ? List.of(only(one, List.of(other)))
        : null;
  }

  private @Nullable List<Code> elements(String variable, Expr.Binary at) {
    if (!isVariable(at.left(), variable) || Exprs.mentions(at.right(), variable)) {
      return null;
    }
    if (at.right() instanceof Expr.SetOf literal) {
      return List.of(only(at.left(), literal.elements()));
    }
    return writer.types().form(at.right().type()) == JavaTypes.Sets.FINITE
        ? List.of(
            tried(
                List.of(at.right()), within(at.left(), element(at.right()), writer.of(at.right()))))
        : null;
  }

  private static Type element(Expr set) {
    return ((Type.SetOf) set.type().base()).element();
  }

  private Code only(Expr variable, List<Expr> elements) {
    Code all = writer.types().list(elements.stream().map(writer::of).toArray(Code[]::new));
    Type its = variable.type();
    Optional<Type> other =
        elements.stream().map(Expr::type).filter(each -> !each.isA(its)).findFirst();
    return tried(elements, within(variable, other.orElse(its), all));
  }

  /** Of values of type {@code of}, those of the variable's type: a {@code nat} is no {@code -1}. */
  private Code within(Expr variable, Type of, Code values) {
    if (Type.isNumber(variable.type(), Type.Num::isWhole)
        && Type.isNumber(of, number -> !number.isWhole())) {
      throw new NotExecutable(
          variable.pos(), "a whole number is sought among values of " + of + "; expected an int");
    }
    return Type.isNumber(of, Type.Num::hasNegative)
            && !Type.isNumber(variable.type(), Type.Num::hasNegative)
        ? Code.call(quantifiers() + ".notNegative", values)
        : values;
  }

  /** The set of values to try; none where the source does not ask the value of these parts. */
  private Code tried(List<Expr> parts, Code set) {
    return guards.isEmpty() || parts.stream().noneMatch(writer::isPartial)
        ? set
        : Code.choice(guards.stream().reduce(Code::and).orElseThrow(), set, writer.types().list());
  }

  /** Evaluates {@code code} for what the source evaluates only if the left side does not decide. */
  private <T extends @Nullable Object> T afterLeft(
      String variable, Expr.Binary of, Supplier<T> code) {
    int before = guards.size();
    guard(variable, of.left(), of.operator() != Operator.OR);
    T result = code.get();
    guards.subList(before, guards.size()).clear();
    return result;
  }

  /** Adds what is known where {@code at} is {@code isTrue}, of all values of the variable. */
  private void guard(String variable, Expr at, boolean isTrue) {
    if (at instanceof Expr.Not not) {
      guard(variable, not.of(), !isTrue);
    } else if (at instanceof Expr.Binary e
        && e.operator() == (isTrue ? Operator.AND : Operator.OR)) {
      guard(variable, e.left(), isTrue);
      guard(variable, e.right(), isTrue);
    } else if (!Exprs.mentions(at, variable)) {
      guards.add(isTrue ? writer.of(at) : Code.not(writer.of(at)));
    }
  }

  private static boolean isVariable(Expr at, String variable) {
    return at instanceof Expr.Variable v && v.name().equals(variable);
  }

  /** Sets of all values of {@code variable} that {@code body} distinguishes. */
  private List<Code> sets(Field variable, Expr body) {
    List<Code> sets = new ArrayList<>();
    writer.elsewhere(
        variable,
        () -> {
          collect(variable.name(), body, sets);
          return sets;
        });
    return sets.stream().distinct().toList();
  }

  private void collect(String variable, Expr at, List<Code> sets) {
    if (!Exprs.mentions(at, variable)) {
      return;
    }
    if (at instanceof Expr.Call call) {
      collect(variable, writer.inlining().body(call), sets);
      return;
    }
    if (at instanceof Expr.Enabled step) {
      collect(variable, writer.inlining().condition(step), sets);
      return;
    }
    if (at instanceof Expr.At e && !(e.map() instanceof Expr.Parameter)) {
      arguments(variable, e, sets);
    } else if (at instanceof Expr.Binary e && e.operator() == Operator.IN) {
      looked(variable, e.left(), e.right(), sets);
    } else if (at instanceof Expr.Binary e
        && (e.operator() == Operator.EQUAL || e.operator() == Operator.UNEQUAL)) {
      compared(variable, e.left(), e.right(), sets);
      compared(variable, e.right(), e.left(), sets);
    }
    if (at instanceof Expr.Binary e
        && List.of(Operator.AND, Operator.OR, Operator.IMPLIES).contains(e.operator())) {
      collect(variable, e.left(), sets);
      afterLeft(
          variable,
          e,
          () -> {
            collect(variable, e.right(), sets);
            return sets;
          });
      return;
    }
    Exprs.parts(at).forEach(part -> collect(variable, part, sets));
  }

  private void arguments(String variable, Expr.At at, List<Code> sets) {
    Code map = writer.of(at.map());
    for (int i = 0; i < at.arguments().size(); i++) {
      Expr argument = at.arguments().get(i);
      if (isVariable(argument, variable)) {
        Type type = ((Type.MapOf) at.map().type().base()).arguments().get(i);
        sets.add(tried(List.of(at), within(argument, type, map.then("arguments"))));
        map = map.then("defaultValue");
      } else {
        map = map.then("at", writer.of(argument));
      }
    }
  }

  private void looked(String variable, Expr element, Expr set, List<Code> sets) {
    if (set instanceof Expr.SetOf literal) {
      for (Expr each : literal.elements()) {
        compared(variable, element, each, sets);
        compared(variable, each, element, sets);
      }
    } else if (isVariable(element, variable)) {
      Code all = writer.of(set);
      boolean isFun = writer.types().form(set.type()) == JavaTypes.Sets.FUN;
      Code elements = isFun ? all.then("arguments") : all;
      sets.add(tried(List.of(set), within(element, element(set), elements)));
    }
  }

  private void compared(String variable, Expr one, Expr other, List<Code> sets) {
    if (isVariable(one, variable) && !isVariable(other, variable)) {
      sets.add(only(one, List.of(other)));
    }
  }
}

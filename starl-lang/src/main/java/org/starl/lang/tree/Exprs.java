package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** Parts of expressions. */
public final class Exprs {

  private Exprs() {}

  /** {@code at} with each part replaced. */
  public static Expr rebuild(Expr at, UnaryOperator<Expr> part) {
    return rebuild(at, at.pos(), part);
  }

  /** {@code at} with each part replaced, and at another place. */
  public static Expr rebuild(Expr at, Pos pos, UnaryOperator<Expr> part) {
    return switch (at) {
      case Expr.At e -> new Expr.At(part.apply(e.map()), all(e.arguments(), part), e.type(), pos);
      case Expr.Call e -> new Expr.Call(e.used(), e.function(), all(e.arguments(), part), pos);
      case Expr.Enabled e ->
          new Expr.Enabled(e.used(), e.automaton(), e.action(), all(e.arguments(), part), pos);
      case Expr.Get e -> new Expr.Get(part.apply(e.of()), e.field(), e.type(), pos);
      case Expr.Make e -> new Expr.Make(e.constructor(), all(e.arguments(), part), e.type(), pos);
      case Expr.MakeRecord e -> new Expr.MakeRecord(all(e.values(), part), e.type(), pos);
      case Expr.Is e -> new Expr.Is(part.apply(e.of()), e.constructor(), pos);
      case Expr.Match e ->
          new Expr.Match(
              part.apply(e.of()),
              e.cases().stream()
                  .map(c -> new Expr.Case(c.constructor(), c.variables(), part.apply(c.value())))
                  .toList(),
              e.type(),
              pos);
      case Expr.Not e -> new Expr.Not(part.apply(e.of()), pos);
      case Expr.Negative e -> new Expr.Negative(part.apply(e.of()), pos);
      case Expr.Binary e ->
          new Expr.Binary(e.operator(), part.apply(e.left()), part.apply(e.right()), e.type(), pos);
      case Expr.Quantified e ->
          new Expr.Quantified(e.forAll(), e.variables(), part.apply(e.body()), pos);
      case Expr.If e ->
          new Expr.If(
              part.apply(e.condition()),
              part.apply(e.then()),
              part.apply(e.otherwise()),
              e.type(),
              pos);
      case Expr.SuchThat e -> new Expr.SuchThat(e.variable(), part.apply(e.body()), e.type(), pos);
      case Expr.SetOf e -> new Expr.SetOf(all(e.elements(), part), e.type(), pos);
      case Expr.MapOf e -> new Expr.MapOf(e.variables(), part.apply(e.body()), e.type(), pos);
      case Expr.ListOf e -> new Expr.ListOf(all(e.elements(), part), e.type(), pos);
      case Expr.Some e -> new Expr.Some(part.apply(e.of()), e.type(), pos);
      case Expr.BuiltIn e -> new Expr.BuiltIn(e.name(), part.apply(e.of()), e.type(), pos);
      case Expr.Bool e -> new Expr.Bool(e.value(), pos);
      case Expr.Numeral e -> new Expr.Numeral(e.value(), e.type(), pos);
      case Expr.Variable e -> new Expr.Variable(e.name(), e.type(), pos);
      case Expr.Parameter e -> new Expr.Parameter(e.name(), e.type(), pos);
      case Expr.Component e -> new Expr.Component(e.name(), e.type(), pos);
      case Expr.Started e -> new Expr.Started(e.used(), e.automaton(), pos);
      case Expr.None e -> new Expr.None(e.type(), pos);
    };
  }

  /** Whether all of these hold. */
  public static Expr all(List<Expr> conditions, Pos pos) {
    return conditions.stream()
        .reduce((a, b) -> new Expr.Binary(Expr.Operator.AND, a, b, Type.Bool.BOOL, pos))
        .orElse(new Expr.Bool(true, pos));
  }

  /** The conditions that {@code and} joins. */
  public static Stream<Expr> conjuncts(Expr at) {
    return at instanceof Expr.Binary and && and.operator() == Expr.Operator.AND
        ? Stream.concat(conjuncts(and.left()), conjuncts(and.right()))
        : Stream.of(at);
  }

  /** A condition that holds, if {@code at} has a value. */
  public static Expr defined(Expr at) {
    return new Expr.Binary(Expr.Operator.EQUAL, at, at, Type.Bool.BOOL, at.pos());
  }

  private static List<Expr> all(List<Expr> parts, UnaryOperator<Expr> part) {
    return parts.stream().map(part).toList();
  }

  /** Its direct parts. */
  public static List<Expr> parts(Expr at) {
    List<Expr> parts = new ArrayList<>();
    rebuild(
        at,
        part -> {
          parts.add(part);
          return part;
        });
    return parts;
  }

  /** Whether {@code at}, or a part of it, has no value for some arguments. */
  public static boolean isPartial(Expr at) {
    boolean isPartial =
        switch (at) {
          case Expr.BuiltIn e ->
              switch (e.name()) {
                case THE, HEAD, TAIL, CARD, CHOOSE, WITHIN -> true;
                case LENGTH, ELEMENTS, DISTINCT -> false;
              };
          case Expr.Get e -> e.of().type().base() instanceof Type.Sum;
          case Expr.Binary e ->
              e.operator() == Expr.Operator.DIVIDED_BY
                  || e.operator() == Expr.Operator.MOD
                  || e.operator() == Expr.Operator.NTH
                  || (e.operator() == Expr.Operator.LESS_BY
                      && !Type.isNumber(e.type(), Type.Num::hasNegative));
          default -> false;
        };
    return isPartial || parts(at).stream().anyMatch(Exprs::isPartial);
  }

  /** The value parameters that {@code at} mentions. */
  public static Set<String> parameters(Expr at) {
    Set<String> names = new TreeSet<>();
    if (at instanceof Expr.Parameter parameter) {
      names.add(parameter.name());
    }
    parts(at).forEach(part -> names.addAll(parameters(part)));
    return names;
  }

  /** Whether a variable of this name occurs in {@code at}, bound ones included. */
  public static boolean mentions(Expr at, String variable) {
    return (at instanceof Expr.Variable v && v.name().equals(variable))
        || parts(at).stream().anyMatch(part -> mentions(part, variable));
  }
}

package org.starl.lang.tree;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Parts of expressions. */
public final class Exprs {

  private Exprs() {}

  /** {@code at} with each part replaced. */
  public static Expr rebuild(Expr at, UnaryOperator<Expr> part) {
    return switch (at) {
      case Expr.At e ->
          new Expr.At(part.apply(e.map()), all(e.arguments(), part), e.type(), e.pos());
      case Expr.Call e -> new Expr.Call(e.used(), e.function(), all(e.arguments(), part), e.pos());
      case Expr.Enabled e ->
          new Expr.Enabled(e.used(), e.automaton(), e.action(), all(e.arguments(), part), e.pos());
      case Expr.Get e -> new Expr.Get(part.apply(e.of()), e.field(), e.type(), e.pos());
      case Expr.Make e ->
          new Expr.Make(e.constructor(), all(e.arguments(), part), e.type(), e.pos());
      case Expr.MakeRecord e -> new Expr.MakeRecord(all(e.values(), part), e.type(), e.pos());
      case Expr.Is e -> new Expr.Is(part.apply(e.of()), e.constructor(), e.pos());
      case Expr.Match e ->
          new Expr.Match(
              part.apply(e.of()),
              e.cases().stream()
                  .map(c -> new Expr.Case(c.constructor(), c.variables(), part.apply(c.value())))
                  .toList(),
              e.type(),
              e.pos());
      case Expr.Not e -> new Expr.Not(part.apply(e.of()), e.pos());
      case Expr.Negative e -> new Expr.Negative(part.apply(e.of()), e.pos());
      case Expr.Binary e ->
          new Expr.Binary(
              e.operator(), part.apply(e.left()), part.apply(e.right()), e.type(), e.pos());
      case Expr.Quantified e ->
          new Expr.Quantified(e.forAll(), e.variables(), part.apply(e.body()), e.pos());
      case Expr.If e ->
          new Expr.If(
              part.apply(e.condition()),
              part.apply(e.then()),
              part.apply(e.otherwise()),
              e.type(),
              e.pos());
      case Expr.SuchThat e ->
          new Expr.SuchThat(e.variable(), part.apply(e.body()), e.type(), e.pos());
      case Expr.SetOf e -> new Expr.SetOf(all(e.elements(), part), e.type(), e.pos());
      case Expr.MapOf e -> new Expr.MapOf(e.variables(), part.apply(e.body()), e.type(), e.pos());
      case Expr.ListOf e -> new Expr.ListOf(all(e.elements(), part), e.type(), e.pos());
      case Expr.Some e -> new Expr.Some(part.apply(e.of()), e.type(), e.pos());
      case Expr.BuiltIn e -> new Expr.BuiltIn(e.name(), part.apply(e.of()), e.type(), e.pos());
      default -> at;
    };
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

  /** Whether a variable of this name occurs in {@code at}, bound ones included. */
  public static boolean mentions(Expr at, String variable) {
    return (at instanceof Expr.Variable v && v.name().equals(variable))
        || parts(at).stream().anyMatch(part -> mentions(part, variable));
  }
}

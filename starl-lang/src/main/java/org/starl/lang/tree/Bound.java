package org.starl.lang.tree;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.UnaryOperator;

/**
 * A bound of a {@link Type.Range}: {@code N - 1}. Equal sums are equal bounds.
 *
 * @param times how often each parameter counts, which is a natural number; not 0
 * @param plus the number that is added
 */
public record Bound(Map<String, Long> times, long plus) {

  /** A number. */
  public static Bound of(long number) {
    return new Bound(Map.of(), number);
  }

  /** A parameter. */
  public static Bound of(String parameter) {
    return new Bound(Map.of(parameter, 1L), 0);
  }

  /** The bound that an expression of whole numbers is; empty if it is none. */
  public static Optional<Bound> of(Expr at) {
    return switch (at) {
      case Expr.Numeral e -> Optional.of(of(e.value().longValueExact()));
      case Expr.Parameter e when e.type() == Type.Num.NAT -> Optional.of(of(e.name()));
      case Expr.Negative e -> of(e.of()).map(Bound::negated);
      case Expr.Binary e -> {
        Optional<Bound> left = of(e.left());
        Optional<Bound> right = of(e.right());
        yield switch (e.operator()) {
          case PLUS -> left.flatMap(a -> right.map(b -> a.plus(1, b)));
          case LESS_BY -> left.flatMap(a -> right.map(b -> a.plus(-1, b)));
          default -> Optional.empty();
        };
      }
      default -> Optional.empty();
    };
  }

  /**
   * {@code this + factor * other}.
   *
   * @throws ArithmeticException if a number becomes too long
   */
  public Bound plus(long factor, Bound other) {
    Map<String, Long> sum = new TreeMap<>(times);
    other.times.forEach(
        (name, n) -> sum.merge(name, Math.multiplyExact(factor, n), Math::addExact));
    sum.values().removeIf(n -> n == 0);
    return new Bound(
        Collections.unmodifiableMap(sum),
        Math.addExact(plus, Math.multiplyExact(factor, other.plus)));
  }

  /** Whether it has no parameter. */
  public boolean isNumber() {
    return times.isEmpty();
  }

  /** Whether it is {@code least} or more for all values of its parameters. */
  public boolean isAtLeast(long least) {
    return plus >= least && times.values().stream().allMatch(n -> n > 0);
  }

  /** Whether it is no more than {@code other}, for all values of the parameters. */
  public boolean isAtMost(Bound other) {
    return other.plus(-1, this).isAtLeast(0);
  }

  /**
   * Its value.
   *
   * @throws ArithmeticException if it is too long
   */
  public long at(Map<String, Integer> values) {
    long sum = plus;
    for (Map.Entry<String, Long> each : times.entrySet()) {
      Integer value = values.get(each.getKey());
      if (value == null) {
        throw new IllegalArgumentException("no value of " + each.getKey());
      }
      sum = Math.addExact(sum, Math.multiplyExact(each.getValue(), value.longValue()));
    }
    return sum;
  }

  /** The least value where each parameter is at most {@code most}. */
  public long least(int most) {
    return plus + most * times.values().stream().mapToLong(n -> Math.min(0, n)).sum();
  }

  /** The same below 0. */
  public Bound negated() {
    return of(0).plus(-1, this);
  }

  /** The same as an expression. */
  public Expr expr(Pos pos) {
    Expr sum = new Expr.Numeral(BigDecimal.valueOf(Math.abs(plus)), Type.Num.NAT, pos);
    if (plus < 0) {
      sum = binary(Expr.Operator.LESS_BY, number(0, pos), sum, pos);
    }
    for (Map.Entry<String, Long> each : times.entrySet()) {
      Expr parameter = new Expr.Parameter(each.getKey(), Type.Num.NAT, pos);
      Expr factor = number(Math.abs(each.getValue()), pos);
      Expr.Operator sign = each.getValue() < 0 ? Expr.Operator.LESS_BY : Expr.Operator.PLUS;
      sum = binary(sign, sum, binary(Expr.Operator.TIMES, factor, parameter, pos), pos);
    }
    return sum;
  }

  private static Expr number(long of, Pos pos) {
    return new Expr.Numeral(BigDecimal.valueOf(of), Type.Num.NAT, pos);
  }

  private static Expr binary(Expr.Operator operator, Expr left, Expr right, Pos pos) {
    return new Expr.Binary(operator, left, right, Type.Num.INT, pos);
  }

  /**
   * What is added comes before what is taken away: {@code 2 * N - 1}; below 0 it begins with
   * {@code first}.
   *
   * @param suffix of numbers
   */
  public String text(String first, UnaryOperator<String> name, String suffix) {
    List<String> added = new ArrayList<>();
    List<String> taken = new ArrayList<>();
    times.forEach((parameter, n) -> {
      String factor = Math.abs(n) == 1 ? "" : Math.abs(n) + suffix + " * ";
      (n < 0 ? taken : added).add(factor + name.apply(parameter));
    });
    if (plus != 0 || times.isEmpty()) {
      (plus < 0 ? taken : added).add(Math.abs(plus) + suffix);
    }
    String sum = String.join(" + ", added);
    String rest = String.join(" - ", taken);
    return rest.isEmpty() ? sum : (added.isEmpty() ? first : sum + " - ") + rest;
  }

  @Override
  public String toString() {
    return text("-", name -> name, "");
  }
}

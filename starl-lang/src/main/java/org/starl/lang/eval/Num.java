package org.starl.lang.eval;

import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * An exact fraction in lowest terms.
 *
 * @param over what is divided
 * @param under what it is divided by; above 0
 */
public record Num(long over, long under) implements Comparable<Num> {

  private static final Num[] SMALL = new Num[64];

  static {
    for (int i = 0; i < SMALL.length; i++) {
      SMALL[i] = new Num(i, 1);
    }
  }

  /** A whole number. */
  public static Num of(long whole) {
    return whole >= 0 && whole < SMALL.length ? SMALL[(int) whole] : new Num(whole, 1);
  }

  /**
   * The number of a source.
   *
   * @throws ArithmeticException if it is too long
   */
  static Num of(BigDecimal decimal) {
    BigInteger under = BigInteger.TEN.pow(Math.max(0, decimal.scale()));
    BigInteger over = decimal.multiply(new BigDecimal(under)).toBigIntegerExact();
    return of(over.longValueExact(), under.longValueExact());
  }

  private static Num of(long over, long under) {
    if (under == 1) {
      return of(over);
    }
    long common = BigInteger.valueOf(over).gcd(BigInteger.valueOf(under)).longValueExact();
    long sign = under < 0 ? -1 : 1;
    return under == sign * common
        ? of(Math.multiplyExact(sign, over / common))
        : new Num(
            Math.multiplyExact(sign, over / common), Math.multiplyExact(sign, under / common));
  }

  boolean isWhole() {
    return under == 1;
  }

  Num plus(Num other) {
    return of(
        Math.addExact(Math.multiplyExact(over, other.under), Math.multiplyExact(other.over, under)),
        Math.multiplyExact(under, other.under));
  }

  Num negative() {
    return of(Math.negateExact(over), under);
  }

  Num times(Num other) {
    return of(Math.multiplyExact(over, other.over), Math.multiplyExact(under, other.under));
  }

  /** {@code other} is not 0. */
  Num dividedBy(Num other) {
    return of(Math.multiplyExact(over, other.under), Math.multiplyExact(under, other.over));
  }

  @Override
  public int compareTo(Num other) {
    return under == other.under
        ? Long.compare(over, other.over)
        : Long.compare(
            Math.multiplyExact(over, other.under), Math.multiplyExact(other.over, under));
  }

  @Override
  public String toString() {
    return under == 1 ? Long.toString(over) : over + "/" + under;
  }
}

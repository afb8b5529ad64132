package org.starl.lang.eval;

import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * An exact fraction in lowest terms; or any number above or below a bound, of which {@link Beyond} is
 * what its bound does not decide.
 *
 * @param over what is divided; or the bound
 * @param under what it is divided by, above 0; 0 for any number above the bound, -1 for any below it
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

  /** Any number above {@code most}. */
  static Num above(long most) {
    return new Num(most, 0);
  }

  private boolean isAny() {
    return under <= 0;
  }

  private boolean isAbove() {
    return under == 0;
  }

  private boolean isBelow() {
    return under < 0;
  }

  private void requireOne() {
    if (isAny()) {
      throw new Beyond();
    }
  }

  boolean isWhole() {
    return under == 1;
  }

  Num plus(Num other) {
    if (isBelow() || other.isBelow()) {
      if (isAbove() || other.isAbove()) {
        throw new Beyond();
      }
      return negative().plus(other.negative()).negative();
    }
    if (isAny() || other.isAny()) {
      if (Math.max(under, other.under) > 1) {
        throw new Beyond();
      }
      return above(Math.addExact(over, other.over));
    }
    return of(
        Math.addExact(Math.multiplyExact(over, other.under), Math.multiplyExact(other.over, under)),
        Math.multiplyExact(under, other.under));
  }

  Num negative() {
    if (isAny()) {
      return new Num(Math.negateExact(over), isBelow() ? 0 : -1);
    }
    return of(Math.negateExact(over), under);
  }

  Num times(Num other) {
    if (isAny() || other.isAny()) {
      boolean isZero = (over == 0 && !isAny()) || (other.over == 0 && !other.isAny());
      if (!isZero
          && (isBelow()
              || other.isBelow()
              || Math.min(over, other.over) < 0
              || Math.max(under, other.under) > 1)) {
        throw new Beyond();
      }
      return isZero ? of(0) : above(Math.multiplyExact(over, other.over));
    }
    return of(Math.multiplyExact(over, other.over), Math.multiplyExact(under, other.under));
  }

  /** {@code other} is not 0. */
  Num dividedBy(Num other) {
    requireOne();
    other.requireOne();
    return of(Math.multiplyExact(over, other.under), Math.multiplyExact(under, other.over));
  }

  /** The remainder of whole numbers, from 0 to {@code other - 1}; {@code other} is above 0. */
  Num mod(Num other) {
    requireOne();
    other.requireOne();
    return of(Math.floorMod(over, other.over));
  }

  @Override
  public int compareTo(Num other) {
    if (isBelow() && other.isAbove() && over <= other.over) {
      return -1;
    }
    if (isBelow() && other.isAny()) {
      throw new Beyond();
    }
    if (isBelow() || other.isBelow()) {
      return other.negative().compareTo(negative());
    }
    if (isAny()) {
      other.requireOne();
      if (other.compareTo(of(over)) > 0) {
        throw new Beyond();
      }
      return 1;
    }
    if (other.isAny()) {
      return -other.compareTo(this);
    }
    return under == other.under
        ? Long.compare(over, other.over)
        : Long.compare(
            Math.multiplyExact(over, other.under), Math.multiplyExact(other.over, under));
  }

  @Override
  public boolean equals(Object other) {
    if (!(other instanceof Num that)) {
      return false;
    }
    boolean isOne = !isAny() && !that.isAny();
    return isOne ? over == that.over && under == that.under : compareTo(that) == 0;
  }

  /** A value that has any number in it is equal to no one value for sure. */
  @Override
  public int hashCode() {
    requireOne();
    return Long.hashCode(over) * 31 + Long.hashCode(under);
  }

  @Override
  public String toString() {
    return isAny()
        ? (isBelow() ? "<" : ">") + over
        : under == 1 ? Long.toString(over) : over + "/" + under;
  }
}

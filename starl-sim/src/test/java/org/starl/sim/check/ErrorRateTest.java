package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import org.junit.jupiter.api.Test;

class ErrorRateTest {

  @Test
  void noBadRunOfManyStillLeavesABound() {
    assertThat(ErrorRate.below(0, 100_000, 0.95)).isCloseTo(2.9957e-5, within(1e-9));
    assertThat(ErrorRate.below(0, 59, 0.95)).isLessThan(0.05);
    assertThat(ErrorRate.below(0, 58, 0.95)).isGreaterThan(0.05);
  }

  @Test
  void theBoundGivesSoFewBadRunsExactlyTheRestOfTheConfidence() {
    for (long[] trial :
        new long[][] {{1, 100}, {3, 20}, {10, 1000}, {19, 20}, {0, 7}, {400, 500}}) {
      for (double confidence : new double[] {0.9, 0.95, 0.99}) {
        double bound = ErrorRate.below(trial[0], trial[1], confidence);
        assertThat(atMost(trial[0], trial[1], bound))
            .as("%d of %d at %s", trial[0], trial[1], confidence)
            .isCloseTo(1 - confidence, within(1e-9));
      }
    }
  }

  @Test
  void onlyBadRunsLeaveNoBound() {
    assertThat(ErrorRate.below(5, 5, 0.95)).isEqualTo(1);
    assertThatThrownBy(() -> ErrorRate.below(2, 1, 0.95)).hasMessageContaining("2 of 1 trials");
    assertThatThrownBy(() -> ErrorRate.below(0, 0, 0.95)).hasMessageContaining("0 of 0 trials");
  }

  /** The binomial distribution, by definition. */
  private static double atMost(long bad, long trials, double probability) {
    MathContext digits = new MathContext(60);
    BigDecimal p = new BigDecimal(probability);
    BigDecimal q = BigDecimal.ONE.subtract(p);
    BigInteger ways = BigInteger.ONE;
    BigDecimal sum = BigDecimal.ZERO;
    for (int k = 0; k <= bad; k++) {
      BigDecimal one = p.pow(k, digits).multiply(q.pow((int) trials - k, digits), digits);
      sum = sum.add(one.multiply(new BigDecimal(ways)), digits);
      ways = ways.multiply(BigInteger.valueOf(trials - k)).divide(BigInteger.valueOf(k + 1));
    }
    return sum.doubleValue();
  }
}

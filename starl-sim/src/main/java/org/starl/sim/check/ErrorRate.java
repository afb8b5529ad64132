package org.starl.sim.check;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Upper bounds of a probability, from independent trials. */
public final class ErrorRate {

  private static final int STEPS = 200;
  private static final double ROUNDING = 1e-9;

  private ErrorRate() {}

  /** A probability for people, with two digits: {@code 4.9 %}, {@code 0.0012 %}. */
  public static String text(double probability) {
    return new BigDecimal(100 * probability)
            .round(new MathContext(2, RoundingMode.HALF_UP))
            .toPlainString()
        + " %";
  }

  /**
   * The exact one-sided upper bound (Clopper, Pearson, "The use of confidence or fiducial limits",
   * Biometrika 26, 1934): with a larger probability so few bad trials, or fewer, would have a
   * probability below {@code 1 - confidence}.
   *
   * @param bad number of bad trials
   * @param trials above 0, at least {@code bad}
   * @param confidence above 0, below 1
   */
  public static double below(long bad, long trials, double confidence) {
    if (bad < 0 || trials <= 0 || bad > trials || !(confidence > 0 && confidence < 1)) {
      throw new IllegalArgumentException(
          bad + " of " + trials + " trials, confidence " + confidence);
    }
    if (bad == trials) {
      return 1;
    }
    if (bad == 0) {
      // 1 - alpha^(1/n), for which rounding would leave few digits.
      return -StrictMath.expm1(StrictMath.log(1 - confidence) / trials);
    }
    return probability(bad, trials, 1 - confidence);
  }

  /** With this probability of a bad one, at most {@code bad} trials are so with {@code chance}. */
  private static double probability(long bad, long trials, double chance) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < STEPS && low < high; i++) {
      double middle = (low + high) / 2;
      if (atMost(bad, trials, middle) > chance) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return high;
  }

  /** A probability, and the bounds between which it is. */
  public record Estimate(double low, double mean, double high) {}

  /**
   * The mean of independent values from 0 to 1 and its two-sided bounds, by the effective number of
   * bad trials (Korn, Graubard, "Confidence intervals for proportions with small expected number of
   * positive counts estimated from survey data", Survey Methodology 24, 1998): as exact as {@link
   * #below} if the values are 0 and 1, and approximate otherwise.
   *
   * @param sum of the values, {@code squares} the sum of their squares
   * @param trials number of the values
   * @param confidence above 0, below 1
   */
  public static Estimate between(double sum, double squares, long trials, double confidence) {
    double oneSided = (1 + confidence) / 2;
    if (sum == 0) {
      return new Estimate(0, 0, below(0, trials, oneSided));
    }
    double mean = sum / trials;
    long bad = Math.max(1, (long) (sum * sum / squares + ROUNDING));
    long like = Math.max(bad, Math.round(bad / mean));
    double low = probability(bad - 1, like, oneSided);
    return new Estimate(low, mean, below(bad, like, oneSided));
  }

  /** The probability of at most {@code bad} bad trials, if each is bad with {@code probability}. */
  private static double atMost(long bad, long trials, double probability) {
    double logOdds = StrictMath.log(probability) - StrictMath.log1p(-probability);
    double logTerm = trials * StrictMath.log1p(-probability);
    double sum = StrictMath.exp(logTerm);
    for (long k = 1; k <= bad; k++) {
      logTerm += StrictMath.log((double) (trials - k + 1) / k) + logOdds;
      sum += StrictMath.exp(logTerm);
    }
    return sum;
  }
}

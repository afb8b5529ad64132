package org.starl.sim.check;

/** Upper bounds of a probability, from independent trials. */
public final class ErrorRate {

  private static final int STEPS = 200;

  private ErrorRate() {}

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
    double low = 0;
    double high = 1;
    for (int i = 0; i < STEPS && low < high; i++) {
      double middle = (low + high) / 2;
      if (atMost(bad, trials, middle) > 1 - confidence) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return high;
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

package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.random.Rng;
import org.starl.sim.Redraws;
import org.starl.spec.SpecReport.Violation;

class SplittingTest {

  private static final int STEPS = 20;
  private static final double UP = 0.25;
  private static final int HIGH = 9;
  private static final int REPETITIONS = 300;
  private static final long SEEDS = 200;

  /** A walk that goes up or down at each ns; it is bad when it is high. Levels: 3, then 6. */
  private static Splitting.Sample walk(long seed, Redraws redraws) {
    Rng.Redraw redraw = new Rng.Redraw();
    Rng rng = new Rng(seed, redraw).fork("walk");
    List<Long> atNs = new ArrayList<>();
    int height = 0;
    for (long now = 0; now < STEPS; now++) {
      for (Redraws.One one : redraws.all()) {
        if (one.atNs() == now) {
          redraw.with(one.number());
        }
      }
      height = Math.max(0, height + (rng.nextBoolean(UP) ? 1 : -1));
      if (height == HIGH) {
        Violation high = new Violation("low", now, List.of(), "high");
        return new Splitting.Sample(RunOutcome.violated(high, new TreeMap<>()), atNs);
      }
      if (atNs.size() < 2 && height == 3 * (atNs.size() + 1)) {
        atNs.add(now);
      }
    }
    return new Splitting.Sample(RunOutcome.good(new TreeMap<>()), atNs);
  }

  /** The probability that such a walk is bad, by its states. */
  private static double exact() {
    double[] at = new double[HIGH + 1];
    at[0] = 1;
    for (int step = 0; step < STEPS; step++) {
      double[] next = new double[HIGH + 1];
      next[HIGH] = at[HIGH];
      for (int height = 0; height < HIGH; height++) {
        next[height + 1] += UP * at[height];
        next[Math.max(0, height - 1)] += (1 - UP) * at[height];
      }
      at = next;
    }
    return at[HIGH];
  }

  private static ErrorRate.Estimate estimate(Splitting splitting, long firstSeed) {
    double sum = 0;
    double squares = 0;
    for (long seed = firstSeed; seed < firstSeed + SEEDS; seed++) {
      double bad = splitting.run(seed, SplittingTest::walk).bad();
      sum += bad;
      squares += bad * bad;
    }
    return ErrorRate.between(sum, squares, SEEDS, 0.95);
  }

  @Test
  void theMeanOfManyEstimatesIsTheProbabilityOfABadRun() {
    double exact = exact();
    assertThat(exact).as("rare").isBetween(1e-5, 5e-4);
    for (Splitting splitting : List.of(new Splitting(2, 2), new Splitting(2, 8))) {
      double sum = 0;
      double squares = 0;
      int within = 0;
      for (int i = 0; i < REPETITIONS; i++) {
        ErrorRate.Estimate estimate = estimate(splitting, 1 + i * SEEDS);
        sum += estimate.mean();
        squares += estimate.mean() * estimate.mean();
        within += estimate.low() <= exact && exact <= estimate.high() ? 1 : 0;
      }
      double mean = sum / REPETITIONS;
      double error = StrictMath.sqrt((squares / REPETITIONS - mean * mean) / REPETITIONS);
      assertThat(Math.abs(mean - exact)).as("%s of %s", mean, exact).isLessThan(3 * error);
      assertThat(within)
          .as("%s: intervals that contain it", splitting)
          .isGreaterThan(95 * REPETITIONS / 100);
    }
  }
}

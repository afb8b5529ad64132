package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class HistogramTest {

  private static List<Double> samples(int count) {
    Random random = new Random(5);
    List<Double> samples = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      samples.add(random.nextGaussian() * StrictMath.pow(10, random.nextInt(9) - 3));
    }
    return samples;
  }

  private static Histogram of(List<Double> samples) {
    Histogram histogram = new Histogram();
    samples.forEach(histogram::add);
    return histogram;
  }

  @Test
  void percentilesOfFewValuesAreExact() {
    List<Double> samples = samples(Histogram.MAX_EXACT);
    Histogram histogram = of(samples);
    Collections.sort(samples);
    for (double percent : new double[] {0, 1, 50, 95, 99.9, 100}) {
      assertThat(histogram.percentile(percent))
          .isEqualTo(samples.get(Percentile.index(samples.size(), percent)));
    }
  }

  @Test
  void percentilesOfManyValuesAreCloseAndDoNotDependOnTheOrder() {
    List<Double> samples = samples(3 * Histogram.MAX_EXACT);
    Histogram histogram = of(samples);
    Collections.shuffle(samples, new Random(1));
    Histogram shuffled = of(samples);
    Collections.sort(samples);
    boolean isRounded = false;
    for (double percent = 0; percent <= 100; percent += 0.5) {
      double exact = samples.get(Percentile.index(samples.size(), percent));
      double shown = histogram.percentile(percent);
      assertThat(shuffled.percentile(percent)).isEqualTo(shown);
      assertThat(shown).isEqualTo(exact, within(Math.abs(exact) / 4096));
      isRounded |= shown != exact;
    }
    assertThat(isRounded).isTrue();
    assertThat(histogram.percentile(100)).isEqualTo(samples.getLast());
  }

  @Test
  void anEmptyHistogramHasNoPercentile() {
    assertThatThrownBy(() -> new Histogram().percentile(50))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new Histogram().add(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
  }
}

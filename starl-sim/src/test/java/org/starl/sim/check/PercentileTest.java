package org.starl.sim.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class PercentileTest {

  @ParameterizedTest
  @CsvSource({
    "1, 0, 0",
    "1, 100, 0",
    "4, 50, 1",
    "5, 50, 2",
    "20, 95, 18",
    "21, 95, 19",
    "100, 99, 98",
    "3, 0, 0",
    "3, 33.4, 1",
    "1000, 100, 999"
  })
  void aPercentileIsTheNearestRank(int count, double percent, int index) {
    assertThat(Percentile.index(count, percent)).isEqualTo(index);
  }

  @Test
  void aPercentileNeedsASampleAndAPercentage() {
    assertThatThrownBy(() -> Percentile.index(0, 50))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("percentile 50.0 of 0 samples");
    assertThatThrownBy(() -> Percentile.index(9, 101)).hasMessageContaining("101");
    assertThatThrownBy(() -> Percentile.index(9, Double.NaN)).hasMessageContaining("NaN");
  }
}

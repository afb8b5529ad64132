package org.starl.time;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TimeTest {

  @Test
  void aTimeIsRoundedToItsDecimals() {
    assertThat(Time.text(12_349_999_999L, 1)).isEqualTo("12.3 s");
    assertThat(Time.text(12_350_000_000L, 1)).isEqualTo("12.4 s");
    assertThat(Time.text(0, 9)).isEqualTo("0.000000000 s");
    assertThat(Time.text(5, 9)).isEqualTo("0.000000005 s");
    assertThat(Time.text(3_600_000_000_000L, 0)).isEqualTo("3600 s");
    assertThat(Time.text(-12_350_000_000L, 1)).isEqualTo("-12.4 s");
    assertThat(Time.text(-4, 1)).isEqualTo("0.0 s");
  }
}

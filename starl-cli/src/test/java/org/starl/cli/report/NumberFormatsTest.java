package org.starl.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NumberFormatsTest {

  @Test
  void numbersHaveTheirSignificantDigits() {
    assertThat(NumberFormats.number(12_345)).isEqualTo("12\u202F345");
    assertThat(NumberFormats.number(1234.4)).isEqualTo("1\u202F234");
    assertThat(NumberFormats.number(100)).isEqualTo("100");
    assertThat(NumberFormats.number(12.34)).isEqualTo("12.3");
    assertThat(NumberFormats.number(0.5)).isEqualTo("0.5");
    assertThat(NumberFormats.number(0.005)).isEqualTo("0.005");
    assertThat(NumberFormats.measured("s", 7)).isEqualTo("7.0\u00A0s");
    assertThat(NumberFormats.measured("s", 0.0434)).isEqualTo("0.043\u00A0s");
    assertThat(NumberFormats.measured("", 0)).isEqualTo("0");
  }

  @Test
  void onlyExactSharesAreWrittenAs0And100Percent() {
    assertThat(NumberFormats.percent(0, 5)).isEqualTo("0\u00A0%");
    assertThat(NumberFormats.percent(5, 5)).isEqualTo("100\u00A0%");
    assertThat(NumberFormats.percent(1, 100_000)).isEqualTo("0.1\u00A0%");
    assertThat(NumberFormats.percent(99_999, 100_000)).isEqualTo("99.9\u00A0%");
    assertThat(NumberFormats.count(1, "run") + NumberFormats.count(2, "run"))
        .isEqualTo("1\u00A0run2\u00A0runs");
  }
}

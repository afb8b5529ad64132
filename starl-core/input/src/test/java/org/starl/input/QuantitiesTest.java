package org.starl.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.math.RoundingMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class QuantitiesTest {

  @ParameterizedTest
  @CsvSource({
    "100ms, 100000000",
    "1.5s, 1500000000",
    "60s, 60000000000",
    "2min, 120000000000",
    "1h, 3600000000000",
    "250us, 250000",
    "7ns, 7",
    "0.1ms, 100000",
    "' 3 ms ', 3000000",
    "0, 0"
  })
  void durationsCarryUnits(String text, long ns) {
    assertThat(Quantities.durationNs(text)).isEqualTo(ns);
  }

  @ParameterizedTest
  @ValueSource(strings = {"100", "ms", "-1s", "1e3ms", "1.ms", "5m", "", "NaN", "99999999999h"})
  void aMalformedDurationIsRefusedInOneLine(String text) {
    assertThatThrownBy(() -> Quantities.durationNs(text))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("'" + text + "': expected a duration")
        .hasMessageNotContaining("\n");
  }

  @Property
  void durationTextsReadBack(@ForAll @LongRange(min = 0, max = Long.MAX_VALUE / 8) long ns) {
    assertThat(Quantities.durationNs(Quantities.durationText(ns))).isEqualTo(ns);
  }

  @Property
  void durationsAreRoundedToTheNearestNs(
      @ForAll @LongRange(min = 0, max = 1_000_000_000) long digits,
      @ForAll @IntRange(min = 0, max = 14) int decimals) {
    BigDecimal ms = BigDecimal.valueOf(digits, decimals);
    BigDecimal ns = ms.movePointRight(6).setScale(0, RoundingMode.HALF_UP);
    assertThat(Quantities.durationNs(ms.toPlainString() + "ms")).isEqualTo(ns.longValueExact());
  }

  @Property
  void numberTextsHaveNoExponent(@ForAll double number) {
    assertThat(Quantities.numberText(number))
        .isEqualTo(BigDecimal.valueOf(number).stripTrailingZeros().toPlainString());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -0.0, 1, 100, -2.5, 0.05, 0.001, 9.99e-4, 9_999_999, 1e7, 1e22})
  void wholeAndLargeNumberTextsToo(double number) {
    numberTextsHaveNoExponent(number);
  }

  @ParameterizedTest
  @CsvSource({"0.5/s, 0.5", "30/min, 0.5", "1800/h, 0.5", "' 6 / min ', 0.1"})
  void ratesCarryUnits(String text, double hz) {
    assertThat(Quantities.rateHz(text)).isEqualTo(hz);
  }

  @ParameterizedTest
  @ValueSource(strings = {"20", "20/", "/min", "0/min", "-1/s", "20/ms", "20min", "20s/min", "x/s"})
  void aMalformedRateIsRefusedInOneLine(String text) {
    assertThatThrownBy(() -> Quantities.rateHz(text))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("expected a rate above 0")
        .hasMessageNotContaining("\n");
  }

  @ParameterizedTest
  @CsvSource({"165, 165", "20mm, 20", "3m, 3000", "2.5cm, 25", "0, 0"})
  void distancesAreInMmUnlessTheySayOtherwise(String text, double mm) {
    assertThat(Quantities.distanceMm(text)).isEqualTo(mm);
  }

  @Property
  void distanceTextsReadBack(@ForAll @DoubleRange(min = 0, max = 1e6) double mm) {
    assertThat(Quantities.distanceMm(Quantities.distanceText(mm))).isEqualTo(mm);
  }

  @ParameterizedTest
  @ValueSource(strings = {"-1", "3km", "1,5", "mm", "1e400"})
  void aMalformedDistanceIsRefused(String text) {
    assertThatThrownBy(() -> Quantities.distanceMm(text))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("'" + text + "': expected a distance");
  }

  @Test
  void anglesSpeedsAndProbabilitiesAreRead() {
    assertThat(Quantities.angleRad("180deg")).isCloseTo(StrictMath.PI, within(1e-12));
    assertThat(Quantities.angleRad("0.5rad")).isEqualTo(0.5);
    assertThat(Quantities.speedMmPerS("0.5m/s")).isEqualTo(500);
    assertThat(Quantities.speedMmPerS("250")).isEqualTo(250);
    assertThat(Quantities.probability("0.05")).isEqualTo(0.05);
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.01", "-0.1", "5%", "half", "2"})
  void aMalformedProbabilityIsRefused(String text) {
    assertThatThrownBy(() -> Quantities.probability(text))
        .isInstanceOf(BadInput.class)
        .hasMessage("'" + text + "': expected a probability from 0 to 1, such as 0.05");
  }

  @Test
  void errorsSayWhereTheTextStood() {
    assertThatThrownBy(
            () -> {
              try {
                Quantities.probability("2");
              } catch (BadInput error) {
                throw Quantities.in("--loss", error);
              }
            })
        .hasMessage("--loss: '2': expected a probability from 0 to 1, such as 0.05");
  }

  @Test
  void quotedTextsFitOneLine() {
    assertThat(BadInput.quote("a\nb\u0000c")).isEqualTo("'a?b?c'");
    assertThat(BadInput.quote("x".repeat(100))).hasSizeLessThan(70).endsWith("...'");
  }
}

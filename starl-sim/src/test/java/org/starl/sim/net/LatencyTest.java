package org.starl.sim.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.input.BadInput;
import org.starl.random.Rng;

final class LatencyTest {

  private static final double MS = 1e6;

  private static double meanMs(Latency latency) {
    Rng rng = new Rng(42);
    double sum = 0;
    int draws = 100_000;
    for (int i = 0; i < draws; i++) {
      sum += latency.drawNs(rng) / MS;
    }
    return sum / draws;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "100ms",
        "uniform(10ms,200ms)",
        "normal(100ms,20ms)",
        "exponential(50ms)",
        "1500us"
      })
  void writtenDelaysAreReadBack(String text) {
    assertThat(Latency.parse(text)).hasToString(text);
    assertThat(Latency.parse(" " + text.replace(",", " , ") + " ")).hasToString(text);
  }

  @Test
  void aConstantDelayCanBeNamed() {
    assertThat(Latency.parse("constant(5ms)")).isEqualTo(new Latency.Constant(5_000_000));
  }

  @Property
  void drawsAreWithinBounds(@ForAll long seed) {
    Rng rng = new Rng(seed);
    for (int i = 0; i < 50; i++) {
      assertThat(Latency.parse("uniform(10ms,20ms)").drawNs(rng))
          .isBetween(10_000_000L, 20_000_000L);
      assertThat(Latency.parse("normal(1ms,50ms)").drawNs(rng)).isNotNegative();
      assertThat(Latency.parse("exponential(50ms)").drawNs(rng)).isNotNegative();
      assertThat(Latency.parse("7ms").drawNs(rng)).isEqualTo(7_000_000L);
    }
  }

  @Property(tries = 50)
  void equalSeedsGiveEqualDelays(@ForAll long seed) {
    Latency latency = Latency.parse("normal(100ms,20ms)");
    Rng one = new Rng(seed);
    Rng other = new Rng(seed);
    for (int i = 0; i < 20; i++) {
      assertThat(latency.drawNs(one)).isEqualTo(latency.drawNs(other));
    }
  }

  @Test
  void theMeansAreAsDeclared() {
    assertThat(meanMs(Latency.parse("uniform(10ms,30ms)"))).isCloseTo(20, within(0.1));
    assertThat(meanMs(Latency.parse("normal(100ms,20ms)"))).isCloseTo(100, within(0.3));
    assertThat(meanMs(Latency.parse("exponential(50ms)"))).isCloseTo(50, within(0.6));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"banana(1)", "banana", "uniform(10ms)", "uniform(1ms,2ms", "", "normal()"})
  void aMalformedDelayIsRefusedWithExamples(String text) {
    assertThatThrownBy(() -> Latency.parse(text))
        .isInstanceOf(BadInput.class)
        .hasMessage(
            "'"
                + text
                + "': expected a delay, 100ms, or uniform(10ms,200ms), normal(100ms,20ms),"
                + " exponential(50ms)");
  }

  @Test
  void badArgumentsAreNamed() {
    assertThatThrownBy(() -> Latency.parse("uniform(10,20ms)"))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("'uniform(10,20ms)': '10': expected a duration with a unit");
    assertThatThrownBy(() -> Latency.parse("uniform(20ms,10ms)"))
        .isInstanceOf(BadInput.class)
        .hasMessage("'uniform(20ms,10ms)': expected uniform(least,most) with 0 <= least <= most");
    assertThatThrownBy(() -> Latency.parse("100"))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("'100': expected a duration with a unit");
  }
}

package org.starl.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;

class AxisTest {

  @Property
  void anAxisReachesItsValuesInAFewRoundSteps(
      @ForAll @Scale(4) @DoubleRange(min = 1e-3, max = 1e9) double most) {
    Axis axis = Axis.upTo("x", most, 6, false);
    assertThat(axis.max()).isGreaterThanOrEqualTo(most * (1 - 1e-8)).isLessThan(most * 1.6 + 1e-9);
    assertThat(axis.steps()).isBetween(2, 6);
    assertThat(String.format("%.0e", axis.step())).matches("[125]e[+-]\\d+");
    assertThat(new HashSet<>(axis.ticks().stream().map(axis::text).toList()))
        .as("ticks that can be told apart")
        .hasSameSizeAs(axis.ticks());
  }

  @Example
  void ticksOfCountsAreWholeNumbers() {
    assertThat(Axis.upTo("n", 2, 5, true).ticks()).containsExactly(0.0, 1.0, 2.0);
    assertThat(Axis.upTo("n", 0, 5, true).ticks()).containsExactly(0.0, 1.0);
  }
}

package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.id.ProcessId;

class BarrierOutcomeTest {

  @Test
  void writtenTextIsReadBack() {
    ProcessId a = ProcessId.parse("a#1");
    ProcessId b = ProcessId.parse("b#4294967297");
    for (BarrierOutcome outcome :
        List.of(
            BarrierOutcome.NONE_YET,
            new BarrierOutcome.Passed(3),
            new BarrierOutcome.Failed(3, new TreeSet<>(List.of(a))),
            new BarrierOutcome.Failed(4, new TreeSet<>(List.of(a, b))),
            new BarrierOutcome.Excluded(0),
            new BarrierOutcome.Unknown(12))) {
      assertThat(BarrierOutcome.parse(outcome.toString())).isEqualTo(outcome);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "passed", ":passed", "x:passed", "3:", "3:failed", "3:failed[]"})
  void malformedOutcomesAreRefused(String text) {
    assertThatThrownBy(() -> BarrierOutcome.parse(text))
        .isInstanceOf(IllegalArgumentException.class);
  }
}

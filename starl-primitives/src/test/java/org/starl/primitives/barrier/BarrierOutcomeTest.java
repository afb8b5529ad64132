package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.JsonFormatException;

class BarrierOutcomeTest {

  private static final ProcessId A = ProcessId.first(new RobotId("a"), 1);
  private static final ProcessId B = ProcessId.first(new RobotId("b"), 2);
  private static final List<BarrierOutcome> OUTCOMES =
      List.of(
          BarrierOutcome.NONE_YET,
          new BarrierOutcome.Passed(3),
          new BarrierOutcome.Failed(3, new TreeSet<>(List.of(A))),
          new BarrierOutcome.Failed(4, new TreeSet<>(List.of(A, B))),
          new BarrierOutcome.Excluded(0),
          new BarrierOutcome.Unknown(12));

  @Test
  void writtenValuesAreReadBack() throws JsonFormatException {
    for (BarrierOutcome outcome : OUTCOMES) {
      String json = BarrierOutcome.SHAPE.json(outcome);
      assertThat(OneSpelling.fromJson(BarrierOutcome.SHAPE, json)).isEqualTo(outcome);
    }
  }

  @Test
  void theTextHasTheGeneration() {
    assertThat(OUTCOMES)
        .extracting(BarrierOutcome::toString)
        .containsExactly(
            "null", "3:passed", "3:failed[a]", "4:failed[a, b.2]", "0:excluded", "12:unknown");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "{}",
        "{\"Other\":{}}",
        "{\"Passed\":{}}",
        "{\"Passed\":{\"generation\":0}}",
        "{\"Failed\":{\"generation\":3}}",
        "{\"Failed\":{\"generation\":3,\"missing\":[\"a.1\"]}}",
        "{\"Failed\":{\"generation\":3,\"missing\":[\"b\",\"a\"]}}"
      })
  void malformedOutcomesAreRefused(String json) {
    assertThatThrownBy(() -> OneSpelling.fromJson(BarrierOutcome.SHAPE, json))
        .isInstanceOf(JsonFormatException.class);
  }
}

package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.JsonFormatException;

class LeaderTest {

  private static final ProcessId ID = new ProcessId(new RobotId("bot1"), 4294967297L);

  @Test
  void writtenValuesAreReadBack() throws JsonFormatException {
    for (Leader leader : List.of(Leader.NONE, Leader.FAIL, new Leader.Name(ID, 3))) {
      assertThat(OneSpelling.fromJson(Leader.SHAPE, Leader.SHAPE.json(leader))).isEqualTo(leader);
    }
  }

  @Test
  void theTextIsThePapers() {
    assertThat(List.of(Leader.NONE, Leader.FAIL, new Leader.Name(ID, 3)))
        .extracting(Leader::toString)
        .containsExactly("null", "fail", "3:bot1");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "{}",
        "{\"None\":{}",
        "{\"Other\":{}}",
        "{\"Name\":{}}",
        "{\"Name\":{\"id\":\"bot1.1\",\"term\":3}}",
        "{\"Name\":{\"id\":\"bot1\",\"term\":0}}"
      })
  void malformedLeadersAreRefused(String json) {
    assertThatThrownBy(() -> OneSpelling.fromJson(Leader.SHAPE, json))
        .isInstanceOf(JsonFormatException.class);
  }
}

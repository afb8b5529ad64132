package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.id.ProcessId;

class LeaderTest {

  @Test
  void writtenTextIsReadBack() {
    ProcessId id = ProcessId.parse("bot1#4294967297");
    for (Leader leader : List.of(Leader.NONE, Leader.FAIL, new Leader.Name(id, 3))) {
      assertThat(Leader.parse(leader.toString())).isEqualTo(leader);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "bot1", ":bot1#1", "x:bot1#1", "3:", "3:bot1"})
  void malformedLeadersAreRefused(String text) {
    assertThatThrownBy(() -> Leader.parse(text)).isInstanceOf(IllegalArgumentException.class);
  }
}

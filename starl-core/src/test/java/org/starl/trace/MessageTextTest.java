package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

class MessageTextTest {

  private record Inner(ProcessId id, List<String> names) {}

  private record Message(long number, Inner inner, List<Inner> all) {}

  private static final ProcessId ID = new ProcessId(new RobotId("bot1"), 7);
  private static final Inner INNER = new Inner(ID, List.of("A", "B"));
  private static final String TEXT = new Message(3, INNER, List.of(INNER, INNER)).toString();

  @Test
  void fieldsOfARecordAreReadBack() {
    assertThat(MessageText.isA("Message", TEXT)).isTrue();
    assertThat(MessageText.isA("Mess", TEXT)).isFalse();
    assertThat(MessageText.field(TEXT, "number")).isEqualTo("3");
    assertThat(MessageText.field(TEXT, "inner")).isEqualTo(INNER.toString());
    assertThat(MessageText.field(MessageText.field(TEXT, "inner"), "id")).isEqualTo("bot1#7");
  }

  @Test
  void elementsOfAListAreReadBack() {
    String all = MessageText.field(TEXT, "all");
    assertThat(MessageText.parts(all)).containsExactly(INNER.toString(), INNER.toString());
    assertThat(MessageText.parts("[A, B]")).containsExactly("A", "B");
    assertThat(MessageText.parts("[]")).isEmpty();
  }

  @Test
  void aMissingFieldIsNamed() {
    assertThatThrownBy(() -> MessageText.field(TEXT, "num"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("expected a field num");
  }
}

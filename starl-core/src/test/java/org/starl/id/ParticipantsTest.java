package org.starl.id;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ParticipantsTest {

  @Test
  void participantsAreSortedByName() {
    Participants some =
        Participants.of(new RobotId("bot10"), new RobotId("bot2"), new RobotId("a"));

    assertThat(some.asList())
        .containsExactly(new RobotId("a"), new RobotId("bot2"), new RobotId("bot10"));
  }

  @Test
  void aRobotIsFoundByTheBytesOfItsNameOnly() {
    for (int size : new int[] {0, 1, 2, 3, 4, 1_000}) {
      List<RobotId> ids = new ArrayList<>();
      for (int i = 0; i < size; i++) {
        ids.add(new RobotId("bot" + i));
      }
      Participants participants = Participants.of(ids);

      for (RobotId id : ids) {
        assertThat(find(participants, id.name())).isEqualTo(id);
      }
      assertThat(find(participants, "bot" + size)).isNull();
      assertThat(find(participants, "bo")).isNull();
      assertThat(find(participants, "")).isNull();
      assertThat(find(participants, "b\u00F6t1")).isNull();
    }
  }

  private static RobotId find(Participants participants, String name) {
    byte[] bytes = (">" + name + "<").getBytes(StandardCharsets.UTF_8);
    return participants.find(bytes, 1, bytes.length - 2);
  }
}

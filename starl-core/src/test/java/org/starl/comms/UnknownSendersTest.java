package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;

class UnknownSendersTest {

  /** More names than are remembered: some replace others. */
  @Test
  void eachSenderHasItsOwnName() {
    UnknownSenders senders = new UnknownSenders();
    for (int i = 0; i < 200; i++) {
      byte[] name = ("from robot" + i % 100).getBytes(StandardCharsets.US_ASCII);
      RobotId id = senders.find(name, 5, name.length - 5);
      assertThat(id).isEqualTo(new RobotId("robot" + i % 100));
    }
  }
}

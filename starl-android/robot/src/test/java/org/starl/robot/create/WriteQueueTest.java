package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import org.junit.jupiter.api.Test;

/** What waits for a line that stands still. */
class WriteQueueTest {

  private final WriteQueue queue = new WriteQueue(20);

  private byte[] written() {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    queue.close();
    queue.writeTo(line, MemoryLink.pair()[0]);
    return line.toByteArray();
  }

  @Test
  void onlyTheNewestSpeedsAreWrittenAfterAStall() {
    for (int speed = 100; speed > 0; speed--) {
      queue.offerNewest(Commands.driveDirect(speed, speed));
    }
    queue.offerNewest(Commands.driveDirect(0, 0));

    assertThat(written()).isEqualTo(Commands.driveDirect(0, 0));
  }

  @Test
  void otherCommandsKeepTheirPlaceBetweenSpeeds() {
    queue.offerNewest(Commands.driveDirect(0, 0));
    queue.offer(Commands.start());
    queue.offerNewest(Commands.driveDirect(1, 1));
    queue.offerNewest(Commands.driveDirect(2, 2));

    assertThat(written()).containsExactly(145, 0, 0, 0, 0, 128, 145, 0, 2, 0, 2);
  }

  @Test
  void itRefusesBytesThatDoNotFit() {
    assertThat(queue.offer(new byte[15])).isTrue();
    assertThat(queue.offer(new byte[6])).isFalse();
    assertThat(queue.offer(new byte[5])).isTrue();
  }
}

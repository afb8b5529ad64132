package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/** What an attacker has recorded. */
class EavesdropperTest {

  private static final RobotId BOT = new RobotId("bot0");

  @Test
  void oldDatagramsAreReplayedAsWellAsNewOnes() {
    Eavesdropper heard = new Eavesdropper(new Rng(7));
    assertThat(heard.recorded()).isEmpty();
    for (int number = 0; number < 4_000; number++) {
      heard.sent(BOT, ByteBuffer.allocate(9).putInt(number).array(), 4);
    }
    int[] quarters = new int[4];
    for (int i = 0; i < 2_000; i++) {
      byte[] datagram = heard.recorded();
      assertThat(datagram).hasSize(4);
      quarters[ByteBuffer.wrap(datagram).getInt() / 1_000]++;
    }
    // A quarter of the one half that is drawn from all; the other half is of the newest.
    assertThat(quarters[0]).isBetween(170, 330);
    assertThat(quarters[1]).isBetween(170, 330);
    assertThat(quarters[2]).isBetween(170, 330);
    assertThat(quarters[3]).isBetween(1_100, 1_400);
  }
}

package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ViewBroadcastTest {

  @Test
  void onlyReceiversOfTheLatestViewCount() {
    ViewBroadcast broadcast = new ViewBroadcast(100);
    broadcast.begin(1, 2, 0);
    broadcast.begin(2, 2, 10);
    broadcast.settled(1);
    broadcast.settled(2);
    broadcast.settled(3);
    assertThat(broadcast.isDone()).isFalse();
    broadcast.settled(2);
    assertThat(broadcast.isDone()).isTrue();
    assertThat(broadcast.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void itIsGivenUpAtItsBound() {
    ViewBroadcast broadcast = new ViewBroadcast(100);
    broadcast.begin(1, 2, 10);
    broadcast.timer(109);
    assertThat(broadcast.isDone()).isFalse();
    assertThat(broadcast.wakeAtNs()).isEqualTo(110);
    broadcast.timer(110);
    assertThat(broadcast.isDone()).isTrue();
    assertThat(broadcast.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }
}

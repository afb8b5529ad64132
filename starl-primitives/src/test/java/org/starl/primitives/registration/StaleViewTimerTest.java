package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.primitives.registration.StaleViewTimer.Due;
import org.starl.random.Rng;

class StaleViewTimerTest {

  private static final long BOUND_NS = 1_000;

  @Property(tries = 50)
  void aRumourIsAskedForAtTheBoundAndCompletedWithinTwoMore(@ForAll long seed) {
    StaleViewTimer timer = new StaleViewTimer(BOUND_NS, new Rng(seed));
    timer.rumour(1, 10);
    assertThat(timer.isListShown()).isFalse();
    assertThat(timer.wakeAtNs()).isEqualTo(10 + BOUND_NS);
    assertThat(timer.timer(9 + BOUND_NS)).isEqualTo(Due.NOTHING);
    assertThat(timer.timer(10 + BOUND_NS)).isEqualTo(Due.ASK);
    assertThat(timer.isListShown()).isTrue();
    assertThat(timer.wakeAtNs()).isBetween(10 + 2 * BOUND_NS, 10 + 3 * BOUND_NS);
    assertThat(timer.timer(timer.wakeAtNs())).isEqualTo(Due.COMPLETE);
    assertThat(timer.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void whatIsLearnedIsNotAskedFor() {
    StaleViewTimer timer = new StaleViewTimer(BOUND_NS, new Rng(1));
    timer.rumour(2, 10);
    timer.learned(1, 20);
    assertThat(timer.isListShown()).isFalse();
    assertThat(timer.wakeAtNs()).isEqualTo(10 + BOUND_NS);
    timer.learned(2, 30);
    assertThat(timer.isListShown()).isTrue();
    assertThat(timer.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }
}

package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import org.junit.jupiter.api.Test;

class RequestTimersTest {

  /** What the request before has waited for does not slow down the next one. */
  @Test
  void eachRequestIsRepeatedSoonAtFirst() {
    RequestTimers timers = new RequestTimers(MutexTimes.DEFAULT);
    long firstNs = MutexTimes.DEFAULT.resendMs() * NS_PER_MS;
    timers.begin(0);
    assertThat(timers.resends(firstNs - 1)).isFalse();
    long atNs = firstNs;
    for (int i = 0; i < 5; i++) {
      assertThat(timers.resends(atNs)).isTrue();
      atNs = timers.wakeAtNs();
    }
    timers.begin(atNs);
    assertThat(timers.wakeAtNs()).isEqualTo(atNs + firstNs);
  }

  @Test
  void theTimeBetweenRepetitionsGrowsUpToItsBound() {
    RequestTimers timers = new RequestTimers(MutexTimes.DEFAULT);
    long mostNs = MutexTimes.DEFAULT.maxResendMs() * NS_PER_MS;
    timers.begin(0);
    long beforeNs = 0;
    long waitNs = 0;
    for (int i = 0; i < 20; i++) {
      long atNs = timers.wakeAtNs();
      assertThat(atNs - beforeNs).isBetween(waitNs, mostNs);
      waitNs = atNs - beforeNs;
      beforeNs = atNs;
      assertThat(timers.resends(atNs)).isTrue();
      timers.endDeadline();
    }
    assertThat(waitNs).isEqualTo(mostNs);
  }
}

package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class WithinTest {

  private final Within<String> within = new Within<>(10);
  private final List<String> expired = new ArrayList<>();

  private void expireAt(long nowNs) {
    within.expire(
        nowNs, (key, since, deadline) -> expired.add(key + " " + since + ".." + deadline));
  }

  @Test
  void anEventExactlyAtTheBoundIsInTime() {
    within.start("a", 5);
    expireAt(15);
    assertThat(within.stop("a")).isTrue();
    expireAt(100);
    assertThat(expired).isEmpty();
  }

  @Test
  void aMissedDeadlineIsReportedOnce() {
    within.start("a", 5);
    expireAt(16);
    expireAt(17);
    assertThat(expired).containsExactly("a 5..15");
    assertThat(within.stop("a")).isFalse();
  }

  @Test
  void startingAgainDoesNotMoveTheDeadline() {
    within.start("a", 5);
    within.start("a", 14);
    expireAt(16);
    assertThat(expired).containsExactly("a 5..15");
  }

  @Test
  void aBrokenAssumptionSuspendsTheDeadlineAndThenGivesTheFullBound() {
    within.start("a", 0);
    within.assume("a", false, 9);
    within.start("a", 20);
    expireAt(50);
    within.assume("a", true, 50);
    within.assume("a", true, 55);
    expireAt(60);
    assertThat(expired).isEmpty();
    expireAt(61);
    assertThat(expired).containsExactly("a 50..60");
  }

  @Test
  void anAssumptionWithoutADeadlineDoesNothing() {
    within.assume("a", true, 0);
    within.assume("a", false, 0);
    assertThat(within.stop("a")).isFalse();
  }

  @Test
  void deadlinesExpireInOrderAfterASuspension() {
    within.start("a", 0);
    within.start("b", 1);
    within.assume("a", false, 2);
    within.assume("a", true, 3);
    expireAt(12);
    assertThat(expired).containsExactly("b 1..11");
    expireAt(14);
    assertThat(expired).containsExactly("b 1..11", "a 3..13");
  }

  @Test
  void aNegativeBoundIsRefused() {
    assertThatThrownBy(() -> new Within<>(-1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-1");
  }

  @Test
  void faultsSuspendAllDeadlinesWhichThenGetTheFullBound() {
    within.start("a", 0);
    within.start("b", 1);
    within.assume("b", false, 2);
    within.assumeAll(false, 5);
    within.start("c", 6);
    within.assumeAll(false, 7);
    expireAt(50);
    within.assumeAll(true, 50);
    within.assumeAll(true, 55);
    expireAt(60);
    assertThat(expired).isEmpty();
    expireAt(61);
    assertThat(expired).containsExactly("a 50..60", "c 50..60");
    assertThat(within.stop("b")).isTrue();
  }
}

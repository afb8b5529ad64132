package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.starl.random.Rng;

/** What is known of another clock holds, whatever the network does within its bounds. */
class ClockMapTest {

  private static final long MS = 1_000_000;
  private static final long MAX_DELAY_NS = 20 * MS;

  /** More than the clocks of these tests drift while an answer of 2 ms is under way, twice. */
  private static final long DRIFT_NS = 4 * ClockMap.DRIFT_NS_PER_MS + 2;

  /** Another clock, which drifts from ours; both in ns. */
  private record Other(long offNs, double driftPpm) {

    long at(long ourNs) {
      return ourNs + offNs + (long) (ourNs * driftPpm * 1e-6);
    }
  }

  private static Other other(Rng rng) {
    return new Other(rng.nextLong(0, 1_000_000_000_000_000L), 190 * (2 * rng.nextDouble() - 1));
  }

  private static void assertIsAbout(TimeSpan span, long earliestNs, long latestNs) {
    assertThat(span.earliestNs()).isBetween(earliestNs - DRIFT_NS, earliestNs);
    assertThat(span.latestNs()).isBetween(latestNs, latestNs + DRIFT_NS);
  }

  private static void assertHolds(ClockMap map, Other other, long eventNs, long nowNs) {
    TimeSpan span = map.span(other.at(eventNs), other.at(eventNs), nowNs);
    assertThat(eventNs).isBetween(span.earliestNs() - 1, span.latestNs() + 1);
    assertThat(Math.abs(eventNs - span.middleNs())).isLessThanOrEqualTo(span.boundNs() + 1);
  }

  @Property(tries = 200)
  void withAnswersTheIntervalContainsTheTruthForAllDelays(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Other other = other(rng);
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    long nowNs = rng.nextLong(1, 1000 * MS);
    for (int i = 0; i < 200; i++) {
      long askedNs = nowNs;
      long heardNs = askedNs + rng.nextLong(1, rng.nextLong(2, 500 * MS));
      nowNs = heardNs + rng.nextLong(1, rng.nextLong(2, 500 * MS));
      map.answered(askedNs, other.at(heardNs), nowNs);
      assertThat(map.isSettled(nowNs)).isTrue();
      long sentNs = nowNs;
      nowNs += rng.nextLong(1, 300 * MS);
      map.received(other.at(sentNs), nowNs);
      assertHolds(map, other, sentNs - rng.nextLong(0, 30 * MS), nowNs);
    }
  }

  @Property(tries = 200)
  void withoutAnswersTheIntervalIsRightIfTheFastestDatagramIsAsAssumed(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Other other = other(rng);
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    long nowNs = 0;
    for (int i = 0; i < 300; i++) {
      long sentNs = nowNs + rng.nextLong(1, 30 * MS);
      nowNs = sentNs + rng.nextLong(0, i % 10 == 0 ? MAX_DELAY_NS : 200 * MS);
      map.received(other.at(sentNs), nowNs);
      if (i > 10) {
        assertHolds(map, other, sentNs, nowNs);
      }
    }
  }

  @Test
  void aSlowerDatagramDoesNotRaiseTheLowerEnd() {
    Other same = new Other(0, 0);
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    map.received(0, MAX_DELAY_NS);
    // The upper end has drifted beyond this one's time by then.
    long sentNs = 2000 * MS;
    long nowNs = sentNs + MAX_DELAY_NS + MS / 4;
    map.received(sentNs, nowNs);
    assertHolds(map, same, sentNs, nowNs);
  }

  @Test
  void driftDoesNotWidenTheIntervalForEver() {
    Other slow = new Other(0, -190);
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    for (long sentNs = 0; sentNs < 1_000_000 * MS; sentNs += 500 * MS) {
      map.received(slow.at(sentNs), sentNs + MS);
      TimeSpan span = map.span(slow.at(sentNs), slow.at(sentNs), sentNs + MS);
      assertThat(span.boundNs()).isLessThan(MAX_DELAY_NS / 2 + 2 * MS);
    }
  }

  @Test
  void aQuickAnswerNarrowsTheInterval() {
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    map.answered(1000 * MS, 5000 * MS, 1002 * MS);
    TimeSpan span = map.span(5000 * MS, 5000 * MS, 1002 * MS);
    assertIsAbout(span, 1000 * MS, 1002 * MS);
    assertThat(span.boundNs()).isCloseTo(MS, within(2 * DRIFT_NS));
    // A slow one later takes nothing of that but the drift.
    map.answered(2000 * MS, 6001 * MS, 2500 * MS);
    assertThat(map.span(6001 * MS, 6001 * MS, 2500 * MS).boundNs()).isLessThan(2 * MS);
  }

  @Test
  void driftDuringAnAnswerIsIncluded() {
    Other fast = new Other(0, 190);
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    map.answered(1000 * MS, fast.at(1000 * MS + 1), 1500 * MS);
    assertHolds(map, fast, 1500 * MS, 1500 * MS);
    assertHolds(map, fast, 1470 * MS, 1500 * MS);
  }

  @Test
  void withoutAnswersAClockIsNotTrustedAtOnce() {
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    assertThat(map.isSettled(0)).isFalse();
    map.received(7000 * MS, 10 * MS);
    assertThat(map.isSettled(10 * MS)).isFalse();
    assertThat(map.isSettled(10 * MS + ClockMap.SETTLE_NS)).isTrue();
  }

  @Property(tries = 50)
  void singleFalseTimesChangeNothingAndAClockThatHasJumpedCountsAfterATime(
      @ForAll @LongRange(min = -100_000, max = 100_000) long jumpMs) {
    Assume.that(jumpMs < -ClockMap.JUMP_NS / MS || jumpMs > 2 * MAX_DELAY_NS / MS);
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    for (int i = 0; i < 200; i++) {
      map.received(7000 * MS + 10 * i * MS, 10 * i * MS);
      map.received((7000 + 10 * i + jumpMs) * MS, 10 * i * MS + 5 * MS);
    }
    assertThat(map.isSettled(2000 * MS)).isTrue();
    assertThat(map.span(9000 * MS, 9000 * MS, 2020 * MS).middleNs())
        .isBetween(1980 * MS, 2001 * MS);
    for (int i = 200; i < 255; i++) {
      map.received((7000 + 10 * i + jumpMs) * MS, 10 * i * MS);
    }
    assertThat(map.isSettled(2550 * MS)).isTrue();
    long senderNs = (9500 + jumpMs) * MS;
    assertThat(map.span(senderNs, senderNs, 2550 * MS).middleNs()).isBetween(2480 * MS, 2501 * MS);
  }

  @Test
  void withAnswersADatagramFromTheFutureIsIgnored() {
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    map.answered(1000 * MS, 5000 * MS, 1002 * MS);
    map.received(9_000_000 * MS, 1003 * MS);
    TimeSpan span = map.span(9_000_000 * MS, 9_000_000 * MS, 1003 * MS);
    assertThat(span.earliestNs()).isGreaterThan(span.latestNs());
    assertThat(map.span(5000 * MS, 5000 * MS, 1003 * MS).boundNs()).isLessThan(2 * MS);
  }

  @Property(tries = 100)
  void onlyContradictoryAnswersInARowStartANewClock(
      @ForAll @LongRange(min = 100, max = 1_000_000) long jumpMs) {
    ClockMap map = new ClockMap(MAX_DELAY_NS);
    map.answered(1000 * MS, 5000 * MS, 1002 * MS);
    for (int i = 2; i < 2 + ClockMap.CONTRADICTIONS; i++) {
      TimeSpan before = map.span(5000 * MS, 5000 * MS, i * 1000 * MS);
      assertThat(before.middleNs()).isBetween(999 * MS, 1003 * MS);
      map.answered(i * 1000 * MS, (4000 + i * 1000 + jumpMs) * MS, (2 + i * 1000) * MS);
    }
    long senderNs = (8000 + jumpMs) * MS;
    assertIsAbout(map.span(senderNs, senderNs, 4002 * MS), 4000 * MS, 4002 * MS);
    assertThat(map.isSettled(4002 * MS)).isFalse();
    assertThat(map.isSettled(4002 * MS + ClockMap.DOUBT_NS)).isTrue();
  }
}

package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.sim.fault.ProbeRun.MS;
import static org.starl.sim.fault.ProbeRun.S;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.spec.Authentic;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/** An attacker without the key disturbs only robots without a key. */
class AttackTest {

  private static final long FROM = 3 * S;
  private static final long UNTIL = 6 * S;
  private static final String FOR_3_S = "at=3s,for=3s)";

  private static long dropped(ProbeRun run, long fromNs, long untilNs) {
    return run.events.stream()
        .filter(TraceEvent.Dropped.class::isInstance)
        .filter(event -> event.timeNs() >= fromNs && event.timeNs() < untilNs)
        .count();
  }

  @ParameterizedTest
  @ValueSource(strings = {"forge(all,5ms)", "replay(all,5ms)"})
  void withoutAKeyForgedAndReplayedDatagramsAreHandled(String attack) {
    assertThat(authentic(ProbeRun.of(attack)).violations("datagrams.Authentic")).isPositive();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "forge(all,5ms)",
        "replay(all,5ms)",
        "duplicate(0.5)",
        "crash(all,at=3s,restart=1s)"
      })
  void withAKeyOnlyGenuineDatagramsAreHandled(String fault) {
    SpecReport report = authentic(ProbeRun.sealed(fault));
    assertThat(report.violations()).isEmpty();
    assertThat(report.checks("datagrams.Authentic")).isGreaterThan(500);
  }

  private static SpecReport authentic(ProbeRun run) {
    Monitors monitors = new Monitors(List.of(new Authentic()));
    run.events.forEach(monitors::observe);
    return monitors.report();
  }

  /** One forged boot number is enough: the robot that it names is dead from then on. */
  @Test
  void forgeriesSilenceRobotsWithoutAKey() {
    ProbeRun run = ProbeRun.of("forge(bot1,10ms," + FOR_3_S);
    assertThat(run.count(0, 1, 0, FROM)).isEqualTo(30);
    assertThat(run.count(0, 1, UNTIL, 12 * S)).isZero();
    assertThat(dropped(run, 0, FROM)).isZero();
    assertThat(dropped(run, FROM, UNTIL)).isGreaterThan(50);
  }

  @Test
  void recordingsReachRobotsWithoutAKey() {
    ProbeRun run = ProbeRun.of("replay(bot1,10ms," + FOR_3_S);
    assertThat(run.count(0, 1, FROM, UNTIL)).isGreaterThan(60);
    assertThat(run.count(0, 1, UNTIL + 20 * MS, 12 * S)).isLessThan(45);
    assertThat(run.count(0, 2, 0, 12 * S)).isEqualTo(100);
  }

  @Test
  void floodsAreDroppedOneByOne() {
    ProbeRun run = ProbeRun.of("flood(bot1,1ms," + FOR_3_S);
    assertThat(dropped(run, FROM, UNTIL)).isBetween(2_500L, 3_500L);
    assertThat(run.count(0, 1, 0, 12 * S)).isEqualTo(100);
  }

  @ParameterizedTest
  @ValueSource(strings = {"forge(all,5ms)", "replay(all,5ms)", "flood(all,5ms)"})
  void withAKeyEveryBeatIsReceivedOnceAndNothingElse(String attack) {
    ProbeRun run = ProbeRun.sealed(attack);
    for (int from = 0; from < 3; from++) {
      for (int to = 0; to < 3; to++) {
        if (from != to) {
          List<Object> beats =
              run.heard(from, to, 0, 12 * S).stream().map(TraceEvent.Delivered::message).toList();
          assertThat(beats).doesNotHaveDuplicates().hasSize(100);
        }
      }
    }
    assertThat(dropped(run, 0, 12 * S)).isGreaterThan(1_000);
  }
}

package org.starl.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.bench.SwarmWorkload.Variant;
import org.starl.sim.SimResult;

/** The runs that b3 measures are the ones that it describes. */
final class SwarmWorkloadTest {

  private static final int ROBOTS = 60;
  private static final int TICKS = 200;

  private static SimResult run(Variant variant, int robots, int ticks) {
    return new SwarmWorkload(variant).plan(robots, ticks, 7).build().run();
  }

  private static long total(SimResult result) {
    return result.results().values().stream().mapToLong(ended -> (Long) ended.get(0)).sum();
  }

  @Test
  void everyRobotBroadcastsInEachTickAndHearsItsNeighbours() {
    Map<Variant, Long> heard = new EnumMap<>(Variant.class);
    for (Variant variant : new Variant[] {Variant.RADIO, Variant.SIGHT}) {
      SimResult result = run(variant, ROBOTS, TICKS);
      assertThat(result.unfinished()).isEmpty();
      assertThat(result.network().sent()).isBetween(ROBOTS * (TICKS - 1L), (long) ROBOTS * TICKS);
      assertThat(total(result)).isEqualTo(result.network().delivered());
      double lost = (double) result.network().lost();
      assertThat(lost / (lost + result.network().delivered())).isBetween(0.09, 0.11);
      heard.put(variant, total(result));
    }
    // 14 robots in a disc of 3 m, less at the edges of a floor of 11 m, and a tenth lost.
    double each = (double) heard.get(Variant.RADIO) / ROBOTS / TICKS;
    assertThat(each).isBetween(7.0, 12.7);
    assertThat(heard.get(Variant.SIGHT))
        .as("what bodies and walls hide")
        .isLessThan(heard.get(Variant.RADIO));
  }

  @Test
  void discsBumpAndComeFree() {
    SimResult result = run(Variant.DISCS, ROBOTS, 1000);
    assertThat(result.unfinished()).isEmpty();
    assertThat(result.collisions().ofRobots()).isPositive();
    assertThat(total(result))
        .as("robots that never come free bump in most ticks")
        .isBetween(1L, ROBOTS * 1000L / 5);
  }

  @Test
  void equalSeedsGiveEqualRuns() {
    for (Variant variant : Variant.values()) {
      SimResult once = run(variant, 20, 50);
      SimResult again = run(variant, 20, 50);
      assertThat(again.events()).isEqualTo(once.events());
      assertThat(again.results()).isEqualTo(once.results());
    }
  }
}

package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.apps.intersection.robot.Car;
import org.starl.random.Rng;

class ArrivalsTest {

  private static final long HOUR_NS = 3_600_000_000_000L;

  private static List<Car> all(Arrivals arrivals, long stepNs) {
    List<Car> all = new ArrayList<>();
    for (long nowNs = 0; nowNs < 20 * HOUR_NS; nowNs += stepNs) {
      List<Car> arrived = arrivals.until(nowNs);
      long latestNs = nowNs;
      assertThat(arrived).allMatch(car -> car.readyNs() <= latestNs);
      all.addAll(arrived);
    }
    return all;
  }

  private static Arrivals arrivals(long seed) {
    return new Arrivals(1 / 3.0, 10 * HOUR_NS, Integer.MAX_VALUE, "bot", new Rng(seed));
  }

  @Test
  void carsArriveAtTheRateOnAllRoutesUntilTheEnd() {
    List<Car> all = all(arrivals(1), HOUR_NS / 3600);
    // 12,000 are expected, with a deviation of 110.
    assertThat((double) all.size()).isCloseTo(12_000, within(550.0));
    assertThat(all.get(all.size() - 1).readyNs()).isLessThan(10 * HOUR_NS);
    Set<String> routes = new TreeSet<>();
    all.forEach(arrival -> routes.add(arrival.trip().label()));
    assertThat(routes).hasSize(12);
    assertThat(all.get(7).id().name()).isEqualTo("bot7");
  }

  /** The share of gaps below the mean is that of an exponential distribution: 1 - 1/e. */
  @Test
  void carsArriveIndependentlyOfEachOther() {
    List<Car> all = all(arrivals(2), HOUR_NS / 3600);
    int below = 0;
    for (int i = 1; i < all.size(); i++) {
      below += all.get(i).readyNs() - all.get(i - 1).readyNs() < 3_000_000_000L ? 1 : 0;
    }
    assertThat(below / (double) all.size()).isCloseTo(1 - 1 / StrictMath.E, within(0.02));
  }

  @Test
  void arrivalsDoNotDependOnWhenTheyAreAskedFor() {
    assertThat(all(arrivals(3), HOUR_NS)).isEqualTo(all(arrivals(3), HOUR_NS / 100));
    assertThat(all(arrivals(3), HOUR_NS)).isNotEqualTo(all(arrivals(4), HOUR_NS));
  }
}

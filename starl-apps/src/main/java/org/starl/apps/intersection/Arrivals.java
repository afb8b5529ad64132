package org.starl.apps.intersection;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Route;
import org.starl.random.Rng;

/**
 * Cars that arrive at random, independently of each other (a Poisson process), each on any of the
 * twelve routes. The cars do not depend on when {@link #poll} is called.
 */
final class Arrivals {

  private static final double NS_PER_S = 1e9;

  private final Crossing crossing;
  private final double rateHz;
  private final long untilNs;
  private final String prefix;
  private final Rng rng;
  private final List<Route> routes = Route.all();
  private double nextNs;
  private int count;

  /**
   * @param rateHz average number of cars per second, on all arms together; above 0
   * @param untilNs no car arrives from then on
   * @param prefix of the cars' names; their number follows
   */
  Arrivals(Crossing crossing, double rateHz, long untilNs, String prefix, Rng rng) {
    this.crossing = crossing;
    this.rateHz = rateHz;
    this.untilNs = untilNs;
    this.prefix = prefix;
    this.rng = rng;
    drawGap();
  }

  /** Removes the next car that has arrived by {@code nowNs}; null if there is none. */
  @Nullable Car poll(long nowNs) {
    if (nextNs > nowNs || nextNs >= untilNs) {
      return null;
    }
    Route route = routes.get(rng.nextInt(routes.size()));
    Car car = Car.atTheEdge(crossing, prefix + count, route, (long) nextNs);
    count++;
    drawGap();
    return car;
  }

  private void drawGap() {
    nextNs += rng.nextExponential() / rateHz * NS_PER_S;
  }
}

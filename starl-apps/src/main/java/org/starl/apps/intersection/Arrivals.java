package org.starl.apps.intersection;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.Route;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * Cars that come at random, independently of each other: a Poisson process, drawn one by one. Each
 * takes any of the twelve routes.
 */
final class Arrivals {

  private static final double NS_PER_S = 1e9;

  private final double rateHz;
  private final long untilNs;
  private final String prefix;
  private final Rng rng;
  private final List<Route> routes = Route.all();
  private double nextNs;
  private int count;

  /**
   * @param rateHz how many come in a second, on average, on all arms together; above 0
   * @param untilNs nobody comes from then on
   * @param prefix of the cars' names; their number follows
   */
  Arrivals(double rateHz, long untilNs, String prefix, Rng rng) {
    this.rateHz = rateHz;
    this.untilNs = untilNs;
    this.prefix = prefix;
    this.rng = rng;
    drawGap();
  }

  /** The next one that has come until {@code nowNs}, or null. */
  @Nullable Arrival poll(long nowNs) {
    if (nextNs > nowNs || nextNs >= untilNs) {
      return null;
    }
    Route route = routes.get(rng.nextInt(routes.size()));
    Arrival arrival = new Arrival(new RobotId(prefix + count), route, (long) nextNs);
    count++;
    drawGap();
    return arrival;
  }

  private void drawGap() {
    nextNs += rng.nextExponential() / rateHz * NS_PER_S;
  }
}

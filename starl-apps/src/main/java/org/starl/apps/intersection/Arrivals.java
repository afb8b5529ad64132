package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.robot.Car;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * Cars that arrive at random, independently of each other (a Poisson process), each on any of the
 * twelve routes. The cars do not depend on when {@link #until} is called.
 */
final class Arrivals {

  private final double rateHz;
  private final long untilNs;
  private final int mostCars;
  private final String prefix;
  private final Rng rng;
  private final List<Route> routes = Route.all();
  private double nextNs;
  private int count;

  /**
   * @param rateHz average number of cars per second, on all arms together; above 0
   * @param untilNs no car arrives from then on
   * @param mostCars no car arrives after so many
   * @param prefix of the cars' names; their number follows
   */
  Arrivals(double rateHz, long untilNs, int mostCars, String prefix, Rng rng) {
    this.rateHz = rateHz;
    this.untilNs = untilNs;
    this.mostCars = mostCars;
    this.prefix = prefix;
    this.rng = rng;
    drawGap();
  }

  /** Removes the cars that have arrived by {@code nowNs}. */
  List<Car> until(long nowNs) {
    List<Car> cars = new ArrayList<>();
    while (nextNs <= nowNs && nextNs < untilNs && !areComplete()) {
      Route route = routes.get(rng.nextInt(routes.size()));
      cars.add(Car.on(route, Crossing.PLACES - 1, prefix + count, (long) nextNs));
      count++;
      drawGap();
    }
    return cars;
  }

  /** Whether as many cars have arrived as may. */
  boolean areComplete() {
    return count >= mostCars;
  }

  private void drawGap() {
    nextNs += rng.nextExponential() / rateHz * Time.NS_PER_S;
  }
}

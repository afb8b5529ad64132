package org.starl.apps.intersection.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.logic.Trip;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * A car of a scenario.
 *
 * @param arm name of its arrival zone; cars of one arm come onto the floor one after another
 * @param start pose at which it comes onto the floor
 * @param readyNs not before this time
 */
public record Car(RobotId id, String arm, Pose start, Trip trip, long readyNs) {

  private static final int MAX_CARS = 12;
  private static final long LATEST_START_MS = 3_000;

  /** A car that starts in the place of {@code rank} on the arm of its route. */
  public static Car on(Route route, int rank, String name, long readyNs) {
    Pose start = Crossing.placePose(route.from(), rank);
    Trip trip = Crossing.trip(route, rank);
    return new Car(new RobotId(name), route.arrival(), start, trip, readyNs);
  }

  /** The cars of Figure 7, all ready from the start. */
  public static List<Car> figure7(String prefix) {
    List<Car> cars = new ArrayList<>();
    for (Route route : Route.FIGURE7) {
      cars.add(on(route, 0, prefix + cars.size(), 0));
    }
    return cars;
  }

  /**
   * {@code count} cars on any of the twelve routes, each of which starts in the first 3 s.
   *
   * @throws BadInput if there are too many, or none
   */
  public static List<Car> drawn(String prefix, int count, Rng rng) {
    if (count < 1 || count > MAX_CARS) {
      throw new BadInput(
          "robots: "
              + count
              + ": expected 1 to "
              + MAX_CARS
              + " cars at the intersection; with arrivals=20/min more come one after another");
    }
    List<Route> routes = Route.all();
    List<Car> cars = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Route route = routes.get(rng.nextInt(routes.size()));
      long readyNs = rng.nextLong(0, LATEST_START_MS) * Time.NS_PER_MS;
      cars.add(on(route, 0, prefix + i, readyNs));
    }
    return cars;
  }
}

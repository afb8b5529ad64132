package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.logic.Turn;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * A car of a scenario.
 *
 * @param arm name of its arrival zone; cars of one arm come onto the floor one after another
 * @param start pose at which it comes onto the floor
 * @param readyNs not before this time
 */
record Car(RobotId id, String arm, Pose start, Trip trip, long readyNs) {

  private static final long NS_PER_MS = 1_000_000;
  private static final long LATEST_START_MS = 3_000;

  /** A car that starts in its arrival zone. */
  static Car atTheHead(Crossing crossing, String name, Route route, long readyNs) {
    Pose start = crossing.placePose(route.from(), 0);
    return new Car(new RobotId(name), route.arrival(), start, crossing.trip(route), readyNs);
  }

  /** A car that arrives at the edge of an open road at {@code atNs}. */
  static Car atTheEdge(Crossing crossing, String name, Route route, long atNs) {
    Pose start = crossing.placePose(route.from(), Crossing.PLACES - 1);
    return new Car(new RobotId(name), route.arrival(), start, crossing.tripFromEdge(route), atNs);
  }

  /**
   * Figure 7 (paper, section 5.3): robot 2 starts in B0 and turns left, robot 1 in D0 goes straight,
   * robots 0 in C0 and 3 in A0 turn right. All are there from the start.
   */
  static List<Car> figure7(Crossing crossing, String prefix) {
    return List.of(
        atTheHead(crossing, prefix + 0, new Route(Zone.C, Turn.RIGHT), 0),
        atTheHead(crossing, prefix + 1, new Route(Zone.D, Turn.STRAIGHT), 0),
        atTheHead(crossing, prefix + 2, new Route(Zone.B, Turn.LEFT), 0),
        atTheHead(crossing, prefix + 3, new Route(Zone.A, Turn.RIGHT), 0));
  }

  /** {@code count} cars on any of the twelve routes, each of which starts in the first 3 s. */
  static List<Car> drawn(Crossing crossing, String prefix, int count, Rng rng) {
    List<Route> routes = Route.all();
    List<Car> cars = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Route route = routes.get(rng.nextInt(routes.size()));
      long readyNs = rng.nextLong(0, LATEST_START_MS) * NS_PER_MS;
      cars.add(atTheHead(crossing, prefix + i, route, readyNs));
    }
    return cars;
  }
}

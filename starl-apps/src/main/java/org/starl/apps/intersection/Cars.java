package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.logic.Turn;
import org.starl.apps.intersection.logic.Zone;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/** The cars of the intersection's own scenarios. */
final class Cars {

  private static final long NS_PER_MS = 1_000_000;
  private static final long LATEST_START_MS = 3_000;

  private Cars() {}

  /**
   * Figure 7 (paper, section 5.3): robot 2 starts in B0 and turns left, robot 1 in D0 goes straight,
   * robots 0 in C0 and 3 in A0 turn right. All are there from the start.
   */
  static List<Car> figure7(Crossing crossing, String prefix) {
    List<Route> routes =
        List.of(
            new Route(Zone.C, Turn.RIGHT),
            new Route(Zone.D, Turn.STRAIGHT),
            new Route(Zone.B, Turn.LEFT),
            new Route(Zone.A, Turn.RIGHT));
    List<Car> cars = new ArrayList<>();
    for (int i = 0; i < routes.size(); i++) {
      cars.add(car(crossing, prefix + i, routes.get(i), 0));
    }
    return cars;
  }

  /** Any of the twelve routes for each of {@code count} cars, which set out in the first 3 s. */
  static List<Car> drawn(Crossing crossing, String prefix, int count, Rng rng) {
    List<Route> routes = Route.all();
    List<Car> cars = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Route route = routes.get(rng.nextInt(routes.size()));
      cars.add(car(crossing, prefix + i, route, rng.nextLong(0, LATEST_START_MS) * NS_PER_MS));
    }
    return cars;
  }

  private static Car car(Crossing crossing, String name, Route route, long readyNs) {
    return new Car(
        new RobotId(name),
        route.arrival(),
        crossing.arrivalPose(route.from()),
        crossing.trip(route),
        readyNs);
  }
}

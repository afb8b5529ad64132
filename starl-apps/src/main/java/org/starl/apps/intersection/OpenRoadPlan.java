package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.starl.apps.Plan;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.RoadsideUnit;
import org.starl.apps.intersection.logic.TowedCar;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.spec.Bounds;
import org.starl.apps.intersection.view.IntersectionLayer;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** The open road: cars come and go, roadside units stay. */
final class OpenRoadPlan {

  private static final String UNIT = "roadside";
  private static final int PLACES = Crossing.PLACES - 1;

  // On each arm one car in each place; four that cross, four that leave.
  private static final int MOST_CARS = 4 * Crossing.PLACES + 8;

  private final String xid;
  private final Crossing crossing;
  private final SimSettings settings;

  OpenRoadPlan(String xid, Crossing crossing, SimSettings settings) {
    this.xid = xid;
    this.crossing = crossing;
    this.settings = settings;
  }

  /**
   * @param rateHz of arrivals
   * @param rng of arrivals; a new one that draws the same at each call
   */
  Plan plan(double rateHz, Obstacles floor, Supplier<Rng> rng) {
    long untilNs = settings.endNs();
    List<RobotId> ids = new ArrayList<>();
    List<Pose> corners = Floor.roadsideUnits(crossing);
    for (int i = 0; i < corners.size(); i++) {
      ids.add(new RobotId(UNIT + i));
    }
    Participants units = Participants.of(ids);
    Supplier<Arrivals> arrivals =
        () -> new Arrivals(rateHz, untilNs, settings.robotName(), rng.get());
    Operator operator = new Operator();
    OpenRoadStory story = new OpenRoadStory(untilNs);
    OpenRoad road =
        new OpenRoad(
            crossing,
            settings.robotRadiusMm(),
            arrivals.get(),
            untilNs,
            (arrival, trip) -> car(arrival, trip, units, operator),
            story,
            operator,
            units);
    Bounds bounds = new Bounds(IntersectionDemo.deltaNs(settings), MOST_CARS, PLACES);
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(settings)
            .endNs(untilNs + bounds.drainNs())
            .obstacles(floor)
            .director(road)
            .observer(operator)
            .observer(story);
    for (int i = 0; i < corners.size(); i++) {
      simulation.robot(
          new RobotSpec(
              ids.get(i), corners.get(i), true, gvh -> new RoadsideUnit(gvh, xid, units)));
    }
    IntersectionDemo.watch(simulation, bounds, settings);
    TripBook trips = new TripBook(crossing, arrivals, settings.robotName());
    return new Plan(simulation, story, new IntersectionLayer(crossing, trips, units), floor);
  }

  private RobotSpec car(Arrival arrival, Trip trip, Participants units, Operator operator) {
    return new RobotSpec(
        arrival.id(),
        crossing.placePose(arrival.route().from(), Crossing.PLACES - 1),
        true,
        gvh ->
            operator.isOffFloor(arrival.id())
                ? new TowedCar(gvh, xid, units, PLACES)
                : new IntersectionApp(gvh, xid, crossing, trip, units));
  }
}

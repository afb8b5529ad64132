package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Plan;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.RoadsideUnit;
import org.starl.apps.intersection.logic.TowedCar;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.spec.Bounds;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.apps.intersection.view.IntersectionLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.motion.MotionSpec;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** Builds the simulation of an intersection: robots, director, story, specifications, picture. */
record IntersectionPlan(Crossing crossing, Obstacles floor, SimSettings settings) {

  private static final String XID = "crossing";
  private static final String UNIT = "roadside";

  // On an open road: one car in each place, four that cross, four that leave.
  private static final int MOST_CARS = 4 * Crossing.PLACES + 8;

  // A message lost in a fault is repeated some time later, and a dead process is suspected later
  // still.
  private static final long AFTER_FAULTS_NS = 15_000_000_000L;

  /** Of a fixed set of cars. */
  Plan closed(List<Car> cars) {
    Operator operator = new Operator();
    IntersectionStory story = new IntersectionStory();
    Simulation.Builder simulation =
        simulation(new Bounds(deltaNs(settings), cars.size(), 0))
            .director(new Traffic(crossing, settings.robotRadiusMm(), cars, operator))
            .observer(operator)
            .observer(story);
    SortedMap<RobotId, Trip> trips = new TreeMap<>();
    for (Car car : cars) {
      trips.put(car.id(), car.trip());
      simulation.robot(
          new RobotSpec(
              car.id(),
              car.start(),
              false,
              gvh ->
                  operator.isOffFloor(car.id())
                      ? new TowedCar(gvh, XID, gvh.id.participants(), 0)
                      : new IntersectionApp(gvh, XID, crossing, car.trip())));
    }
    return new Plan(simulation, story, new IntersectionLayer(crossing, trips), floor);
  }

  /** Of an open road, on which cars arrive until the settings' end of the run. */
  Plan open(double rateHz, Rng rng) {
    long untilNs = settings.endNs();
    SortedMap<RobotId, Pose> posts = new TreeMap<>();
    for (Pose pose : Floor.roadsideUnits(crossing)) {
      posts.put(new RobotId(UNIT + posts.size()), pose);
    }
    Participants units = Participants.of(new ArrayList<>(posts.keySet()));
    Operator operator = new Operator();
    OpenRoadStory story = new OpenRoadStory(untilNs);
    OpenRoad road =
        new OpenRoad(
            crossing,
            settings.robotRadiusMm(),
            new Arrivals(crossing, rateHz, untilNs, settings.robotName(), rng),
            untilNs,
            car -> robot(car, units, operator),
            story,
            operator,
            units);
    Bounds bounds = new Bounds(deltaNs(settings), MOST_CARS, Crossing.CLAIMED_PLACES);
    Simulation.Builder simulation =
        simulation(bounds)
            .endNs(untilNs + bounds.drainNs())
            .director(road)
            .observer(operator)
            .observer(story);
    posts.forEach((id, pose) ->
        simulation.robot(new RobotSpec(id, pose, true, gvh -> new RoadsideUnit(gvh, XID, units))));
    return new Plan(simulation, story, new IntersectionLayer(crossing, units), floor);
  }

  private RobotSpec robot(Car car, Participants units, Operator operator) {
    return new RobotSpec(
        car.id(),
        car.start(),
        true,
        gvh ->
            operator.isOffFloor(car.id())
                ? new TowedCar(gvh, XID, units, Crossing.CLAIMED_PLACES)
                : new IntersectionApp(gvh, XID, crossing, car.trip(), units));
  }

  /** A simulation without robots that checks all specifications. */
  Simulation.Builder simulation(Bounds bounds) {
    Simulation.Builder simulation = Simulation.builder().settings(settings).obstacles(floor);
    IntersectionSpec.of(XID, crossing, bounds).forEach(simulation::monitor);
    MotionParameters motion = Crossing.motion(settings.motionParameters(0));
    return simulation.monitor(() -> new MotionSpec(motion));
  }

  /** A message that is repeated until it is answered arrives within this time. */
  static long deltaNs(SimSettings settings) {
    boolean hasFaults =
        !settings.get(Setting.FAULTS).isEmpty() || settings.get(Setting.CHAOS) != Envelope.NONE;
    return Bounds.deltaNs(settings.messageDelay().longestNs(), settings.messageLoss().probability())
        + (hasFaults ? AFTER_FAULTS_NS : 0);
  }
}

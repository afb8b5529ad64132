package org.starl.apps.intersection;

import static org.starl.apps.intersection.robot.IntersectionFactory.XID;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.apps.Plan;
import org.starl.apps.Story;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.RoadsideUnit;
import org.starl.apps.intersection.logic.TowedCar;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarMaker;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.Floor;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.apps.intersection.spec.TrafficConformance;
import org.starl.apps.intersection.view.IntersectionLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.primitives.motion.MotionSpec;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/** Builds the simulation of an intersection: robots, director, story, specifications, picture. */
record IntersectionPlan(Obstacles floor, SimSettings settings, CarMaker program) {

  private static final String UNIT = "roadside";

  // On an open road: one car in each place, four that cross, four that leave.
  private static final int MOST_CARS = 4 * Crossing.PLACES + 8;

  // A message lost in a fault is repeated some time later, and a dead process is suspected later
  // still.
  private static final long AFTER_FAULTS_NS = 15 * Time.NS_PER_S;

  IntersectionPlan {
    double mostMm = Crossing.LANE_MM / 2;
    if (settings.robotRadiusMm() >= mostMm) {
      throw new BadInput(
          "robotRadius=%s: expected below %s, half the width of a lane"
              .formatted(
                  Quantities.distanceText(settings.robotRadiusMm()),
                  Quantities.distanceText(mostMm)));
    }
  }

  /** Of a fixed set of cars. */
  Plan closed(List<Car> cars) {
    Traffic traffic = new Traffic(settings.robotRadiusMm(), cars);
    Simulation.Builder simulation =
        simulation(
            new IntersectionSpec(deltaNs(settings), cars.size(), 0, turnNs()),
            cars.stream().map(Car::id).toList());
    SortedMap<RobotId, Trip> trips = new TreeMap<>();
    for (Car car : cars) {
      trips.put(car.id(), car.trip());
      simulation.robot(robot(car, false, gvh -> gvh.id.participants(), traffic));
    }
    IntersectionLayer layer = new IntersectionLayer(trips);
    return plan(simulation, traffic, new IntersectionStory(), layer);
  }

  /**
   * Of an open road, on which cars arrive until the settings' end of the run, at most {@code
   * mostCars}.
   */
  Plan open(double rateHz, int mostCars, Rng rng) {
    return open(rateHz, mostCars, rng, simulation(openSpec()));
  }

  /** Without specifications, which other rules of the way would violate. */
  Plan openUnchecked(double rateHz, Rng rng) {
    return open(
        rateHz, Integer.MAX_VALUE, rng, Simulation.builder().settings(settings).obstacles(floor));
  }

  private long turnNs() {
    return program == CarProgram.FLOW ? IntersectionSpec.FLOWING_NS : IntersectionSpec.STOPPING_NS;
  }

  private IntersectionSpec openSpec() {
    return new IntersectionSpec(deltaNs(settings), MOST_CARS, Crossing.CLAIMED_PLACES, turnNs());
  }

  private Plan open(double rateHz, int mostCars, Rng rng, Simulation.Builder simulation) {
    long untilNs = settings.endNs();
    SortedMap<RobotId, Pose> posts = new TreeMap<>();
    for (Point at : Floor.roadsideUnits()) {
      posts.put(new RobotId(UNIT + posts.size()), Pose.of(at, 0));
    }
    Participants units = Participants.of(posts.keySet());
    OpenRoadStory story =
        new OpenRoadStory(
            untilNs, settings.robotRadiusMm(), settings.motionParameters(0).linSpeedMaxMmPerS());
    OpenRoad road =
        new OpenRoad(
            settings.robotRadiusMm(),
            new Arrivals(rateHz, untilNs, mostCars, settings.robotName(), rng),
            untilNs,
            units,
            (car, traffic) -> robot(car, true, gvh -> units, traffic),
            story);
    simulation.endNs(untilNs + openSpec().drainNs());
    posts.forEach((id, pose) ->
        simulation.robot(new RobotSpec(id, pose, true, gvh -> new RoadsideUnit(gvh, XID, units))));
    return plan(simulation, road, story, new IntersectionLayer(units));
  }

  private Plan plan(
      Simulation.Builder simulation, Traffic traffic, Story story, IntersectionLayer layer) {
    simulation.director(traffic).observer(traffic).observer(story);
    return new Plan(simulation, story, layer, floor);
  }

  private RobotSpec robot(
      Car car,
      boolean onFloor,
      Function<GlobalVarHolder, Participants> acceptors,
      Traffic traffic) {
    return new RobotSpec(
        car.id(),
        car.start(),
        onFloor,
        gvh ->
            traffic.isOffFloor(car.id())
                ? new TowedCar(gvh, XID, acceptors.apply(gvh), !car.trip().approach().isEmpty())
                : program.of(gvh, car.trip(), acceptors.apply(gvh)));
  }

  /** A simulation without robots that checks all specifications. */
  Simulation.Builder simulation(IntersectionSpec spec) {
    return simulation(spec, List.of());
  }

  private Simulation.Builder simulation(IntersectionSpec spec, List<RobotId> cars) {
    Simulation.Builder simulation = Simulation.builder().settings(settings).obstacles(floor);
    List<RobotId> stray = settings.strayRobots(cars);
    spec.monitors(XID, stray).forEach(simulation::monitor);
    if (program == CarProgram.PAPER && stray.isEmpty()) {
      simulation.monitor(() -> new TrafficConformance(XID));
    }
    MotionParameters motion = Crossing.motion(settings.motionParameters(0));
    return simulation.monitor(() ->
        program == CarProgram.FLOW ? new MotionSpec(motion).inLanes() : new MotionSpec(motion));
  }

  /** A message that is repeated until it is answered arrives within this time. */
  static long deltaNs(SimSettings settings) {
    return IntersectionSpec.deltaNs(
            settings.messageDelay().longestNs(), settings.messageLoss().probability())
        + (settings.hasFaults() ? AFTER_FAULTS_NS : 0);
  }
}

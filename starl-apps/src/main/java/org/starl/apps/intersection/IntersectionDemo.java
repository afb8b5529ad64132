package org.starl.apps.intersection;

import java.nio.file.Path;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.RobotId;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Scenario;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.apps.intersection.view.IntersectionLayer;
import org.starl.geometry.Obstacles;
import org.starl.motion.MotionParameters;
import org.starl.primitives.motion.MotionSpec;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.input.BadInput;
import org.starl.sim.input.Quantities;

/** The paper's section 3: {@code starl run intersection}. */
public final class IntersectionDemo implements Demo {

  private static final String XID = "crossing";
  private static final int MIN_CARS = 1;
  private static final int MAX_CARS = 12;
  private static final int MAX_DEBRIS = 8;

  private static final Parameter SCENARIO =
      new Parameter("scenario", "drawn", "one of the scenarios above");
  private static final List<Scenario> SCENARIOS =
      List.of(
          new Scenario("drawn", "1 to 12 cars on any of the twelve routes, from the seed"),
          new Scenario("figure7", "the paper's four cars, with 100 ms mean delay"),
          new Scenario("legacy", "the original StarL's files; needs files=FOLDER"));

  private static final Parameter DEBRIS =
      new Parameter(
          "debris",
          "1",
          "pieces of debris on the crossing, 0 to 8, from the seed: nobody knows of them, and"
              + " somebody clears them away after 5 to 30 s");
  private static final Parameter FILES =
      new Parameter(
          "files", "", "folder of start.wpt, dest.wpt and obstacles.wpt, for scenario=legacy");

  @Override
  public String name() {
    return "intersection";
  }

  @Override
  public String summary() {
    return "cars register, ask for their zones, cross and release (paper, section 3)";
  }

  @Override
  public List<Scenario> scenarios() {
    return SCENARIOS;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(SCENARIO, DEBRIS, FILES);
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    SimSettings.Builder settings = SimSettings.builder();
    settings.set(Setting.FLOOR_HEIGHT, settings.build().get(Setting.FLOOR_WIDTH));
    if (request.parameter(SCENARIO.key()).equals("figure7")) {
      settings.set(Setting.MESSAGE_DELAY.key(), "uniform(80ms,120ms)");
    }
    return settings;
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    Crossing crossing = Crossing.STANDARD;
    Rng rng = new Rng(request.seed()).fork(name());
    Obstacles obstacles = Floor.kerbs(crossing);
    List<Car> cars;
    String scenario = request.parameter(SCENARIO.key());
    switch (scenario) {
      case "drawn" -> {
        int count = request.robots().orElse(settings.robots());
        if (count < MIN_CARS || count > MAX_CARS) {
          throw new BadInput("robots: " + count + ": expected 1 to 12 cars at the intersection");
        }
        cars = Cars.drawn(crossing, settings.robotName(), count, rng.fork("cars"));
      }
      case "figure7" -> {
        cars = Cars.figure7(crossing, settings.robotName());
        requireCount(request, cars.size(), scenario);
      }
      case "legacy" -> {
        if (request.parameter(FILES.key()).isEmpty()) {
          throw new BadInput("files='': expected the folder of the original's .wpt files");
        }
        LegacyFiles files = LegacyFiles.read(Path.of(request.parameter(FILES.key())), crossing);
        cars = files.cars();
        obstacles = files.obstacles();
        requireCount(request, cars.size(), scenario);
      }
      default ->
          throw new BadInput(
              "scenario=" + BadInput.quote(scenario) + ": expected drawn, figure7 or legacy");
    }
    Obstacles floor = Floor.withDebris(obstacles, crossing, debris(request), rng.fork("debris"));
    return simulation(crossing, cars, floor, settings);
  }

  private Plan simulation(
      Crossing crossing, List<Car> cars, Obstacles floor, SimSettings settings) {
    IntersectionStory story = new IntersectionStory();
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(settings)
            .obstacles(floor)
            .director(new Traffic(crossing, settings.robotRadiusMm(), cars))
            .observer(story);
    for (Car car : cars) {
      simulation.robot(
          new RobotSpec(
              car.id(),
              car.start(),
              false,
              gvh -> new IntersectionApp(gvh, XID, crossing, car.trip())));
    }
    SortedMap<RobotId, Trip> trips = new TreeMap<>();
    SortedMap<RobotId, List<String>> paths = new TreeMap<>();
    for (Car car : cars) {
      trips.put(car.id(), car.trip());
      paths.put(car.id(), car.trip().zones());
    }
    IntersectionSpec.of(XID, crossing, paths).forEach(simulation::monitor);
    MotionParameters motion = IntersectionApp.motion(settings.motionParameters(0));
    simulation.monitor(() -> new MotionSpec(motion));
    return new Plan(simulation, story, new IntersectionLayer(crossing, trips), floor);
  }

  private static int debris(Request request) {
    try {
      return (int) Quantities.whole(request.parameter(DEBRIS.key()), 0, MAX_DEBRIS);
    } catch (BadInput error) {
      throw Quantities.in(DEBRIS.key(), error);
    }
  }

  private static void requireCount(Request request, int cars, String scenario) {
    if (request.robots().isPresent() && request.robots().getAsInt() != cars) {
      throw new BadInput(
          "robots: " + request.robots().getAsInt() + ": expected " + cars + " for " + scenario);
    }
  }
}

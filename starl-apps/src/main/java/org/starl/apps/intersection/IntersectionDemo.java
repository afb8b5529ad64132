package org.starl.apps.intersection;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Demo;
import org.starl.apps.Input;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Scenario;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.TowedCar;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.spec.Bounds;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.apps.intersection.view.IntersectionLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.input.Quantity;
import org.starl.primitives.motion.MotionSpec;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** The paper's section 3: {@code starl run intersection}. */
public final class IntersectionDemo implements Demo {

  private static final String XID = "crossing";
  private static final int MIN_CARS = 1;
  private static final int MAX_CARS = 12;
  private static final int MAX_DEBRIS = 8;
  private static final Crossing CROSSING = Crossing.STANDARD;
  private static final String OPEN = "open";
  private static final String DEFAULT_ARRIVALS = "20/min";
  private static final long AFTER_FAULTS_NS = 15_000_000_000L;
  private static final long MAX_ARRIVALS_NS = 1000L * 3600 * 1_000_000_000;

  private static final Parameter SCENARIO =
      new Parameter("scenario", "drawn", "one of the scenarios above");
  private static final List<Scenario> SCENARIOS =
      List.of(
          new Scenario("drawn", "1 to 12 cars on any of the twelve routes, from the seed"),
          new Scenario("figure7", "the paper's four cars, with 100 ms mean delay"),
          new Scenario("open", "cars arrive at random for as long as --for says; see arrivals"),
          new Scenario("legacy", "the original StarL's files; needs files=FOLDER"));

  private static final Parameter DEBRIS =
      new Parameter(
          "debris",
          "1",
          "pieces of debris on the crossing, 0 to 8, from the seed: nobody knows of them, and"
              + " somebody clears them away after 5 to 30 s",
          Form.whole(0, MAX_DEBRIS));
  private static final Parameter ARRIVALS =
      new Parameter(
          "arrivals",
          "",
          "for scenario=open, which it implies: how often cars arrive, such as 20/min (the default)",
          Form.above0(Quantity.RATE));
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
    return List.of(SCENARIO, ARRIVALS, DEBRIS, FILES);
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public List<Input> inputs(Path data) {
    Path folder = data.resolve("starl-original/intersection");
    return List.of(
        new Input(
            "intersection/",
            folder,
            new TreeMap<>(Map.of(SCENARIO.key(), "legacy", FILES.key(), folder.toString())),
            "25 of 25 good at 0, 20 and 40 % loss; at 60 %, 3 of 5 stuck, 1 of 5 overlapping"));
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
    Rng rng = new Rng(request.seed()).fork(name());
    return isOpen(request) ? openRoad(request, settings, rng) : closed(request, settings, rng);
  }

  private static boolean isOpen(Request request) {
    String scenario = request.parameter(SCENARIO.key());
    if (scenario.equals(OPEN)) {
      return true;
    }
    boolean hasArrivals = !request.parameter(ARRIVALS.key()).isEmpty();
    if (hasArrivals && !scenario.equals(SCENARIO.defaultValue())) {
      throw new BadInput("arrivals with scenario=" + scenario + ": expected scenario=" + OPEN);
    }
    return hasArrivals;
  }

  private static Plan openRoad(Request request, SimSettings settings, Rng rng) {
    if (request.robots().isPresent()) {
      throw new BadInput("robots: expected none given: on an open road arrivals decide");
    }
    String rate = request.parameter(ARRIVALS.key());
    double rateHz;
    try {
      rateHz = Quantities.rateHz(rate.isEmpty() ? DEFAULT_ARRIVALS : rate);
    } catch (BadInput error) {
      throw Quantities.in(ARRIVALS.key(), error);
    }
    if (settings.endNs() > MAX_ARRIVALS_NS) {
      throw new BadInput("duration: expected from 1ms to 1000h, for as long as cars arrive");
    }
    Obstacles floor =
        Floor.withDebris(Floor.kerbs(CROSSING), CROSSING, debris(request), rng.fork("debris"));
    return new OpenRoadPlan(XID, CROSSING, settings)
        .plan(rateHz, floor, () -> rng.fork("arrivals"));
  }

  private static Plan closed(Request request, SimSettings settings, Rng rng) {
    Obstacles obstacles = Floor.kerbs(CROSSING);
    List<Car> cars;
    String scenario = request.parameter(SCENARIO.key());
    switch (scenario) {
      case "drawn" -> {
        int count = request.robots().orElse(settings.robots());
        if (count < MIN_CARS || count > MAX_CARS) {
          throw new BadInput("robots: " + count + ": expected 1 to 12 cars at the intersection");
        }
        cars = Cars.drawn(CROSSING, settings.robotName(), count, rng.fork("cars"));
      }
      case "figure7" -> {
        cars = Cars.figure7(CROSSING, settings.robotName());
        requireCount(request, cars.size(), scenario);
      }
      case "legacy" -> {
        if (request.parameter(FILES.key()).isEmpty()) {
          throw new BadInput("files='': expected the folder of the original's .wpt files");
        }
        LegacyFiles files = LegacyFiles.read(Path.of(request.parameter(FILES.key())), CROSSING);
        cars = files.cars();
        obstacles = files.obstacles();
        requireCount(request, cars.size(), scenario);
      }
      default ->
          throw new BadInput(
              "scenario=" + BadInput.quote(scenario) + ": expected drawn, figure7, legacy or open");
    }
    Obstacles floor = Floor.withDebris(obstacles, CROSSING, debris(request), rng.fork("debris"));
    return simulation(cars, floor, settings);
  }

  private static Plan simulation(List<Car> cars, Obstacles floor, SimSettings settings) {
    IntersectionStory story = new IntersectionStory();
    Operator operator = new Operator();
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(settings)
            .obstacles(floor)
            .director(new Traffic(CROSSING, settings.robotRadiusMm(), cars, operator))
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
                      : new IntersectionApp(gvh, XID, CROSSING, car.trip())));
    }
    watch(simulation, new Bounds(deltaNs(settings), cars.size(), 0), settings);
    return new Plan(simulation, story, new IntersectionLayer(CROSSING, trips), floor);
  }

  /** Adds everything that is checked in a run of the intersection. */
  static void watch(Simulation.Builder simulation, Bounds bounds, SimSettings settings) {
    IntersectionSpec.of(XID, CROSSING, bounds).forEach(simulation::monitor);
    MotionParameters motion = Crossing.motion(settings.motionParameters(0));
    simulation.monitor(() -> new MotionSpec(motion));
  }

  /** Within this time a message arrives that is repeated until it is answered. */
  static long deltaNs(SimSettings settings) {
    boolean hasFaults =
        !settings.get(Setting.FAULTS).isEmpty() || settings.get(Setting.CHAOS) != Envelope.NONE;
    // What was lost in a fault is repeated after a while, and who has died is given up after
    // another.
    return Bounds.deltaNs(settings.messageDelay().longestNs(), settings.messageLoss().probability())
        + (hasFaults ? AFTER_FAULTS_NS : 0);
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

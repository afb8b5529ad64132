package org.starl.apps.intersection;

import static org.starl.apps.intersection.robot.IntersectionFactory.ARRIVALS;
import static org.starl.apps.intersection.robot.IntersectionFactory.CAR;
import static org.starl.apps.intersection.robot.IntersectionFactory.DRAWN;
import static org.starl.apps.intersection.robot.IntersectionFactory.FIGURE7;
import static org.starl.apps.intersection.robot.IntersectionFactory.FILES;
import static org.starl.apps.intersection.robot.IntersectionFactory.SCENARIO;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Input;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Scenario;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarMaker;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.Floor;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.geometry.Obstacles;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.Envelope;
import org.starl.time.Time;

/** The paper's section 3: {@code starl run intersection}. */
public final class IntersectionDemo implements FactoryDemo {

  private static final String OPEN = "open";
  private static final String DEFAULT_ARRIVALS = "20/min";

  // Many times what the crossing can serve; a run makes no progress at rates far above.
  private static final double MAX_ARRIVALS_HZ = 10;

  private static final Duration TIME_FOR_ALL = Duration.ofHours(24);
  private static final long MAX_ARRIVALS_NS = 1000 * 3600 * Time.NS_PER_S;

  private static final IntersectionFactory FACTORY = new IntersectionFactory();
  private static final List<Scenario> SCENARIOS =
      List.of(
          new Scenario(DRAWN, "1 to 12 cars on any of the twelve routes, from the seed"),
          new Scenario(FIGURE7, "the paper's four cars, with 100 ms mean delay"),
          new Scenario(
              "open", "cars arrive at random until the time of --for, or --robots; see arrivals"),
          new Scenario("legacy", "the original StarL's files; needs files=FOLDER"));

  @Override
  public AppFactory factory() {
    return FACTORY;
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
  public Request varied(Request request) {
    if (!scenario(request).equals(DRAWN)) {
      return request;
    }
    Request drawn = request.drawRobots(2, 12);
    if (!request.given().contains(SCENARIO.key())) { // arrivals change the scenario
      drawn = drawn.drawParameter(ARRIVALS, DEFAULT_ARRIVALS);
    }
    // The cars of the paper do not keep up with arrivals.
    return scenario(drawn).equals(DRAWN)
        ? drawn.drawParameter(CAR, request.seed() % 2 == 0 ? "paper" : "program")
        : drawn;
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    SimSettings.Builder settings = SimSettings.builder();
    settings.set(Setting.FLOOR_HEIGHT, settings.build().get(Setting.FLOOR_WIDTH));
    if (request.parameter(SCENARIO.key()).equals(FIGURE7)) {
      settings.set(Setting.MESSAGE_DELAY.key(), "uniform(80ms,120ms)");
    }
    if (request.robots().isPresent() && scenario(request).equals(OPEN)) {
      settings.duration(TIME_FOR_ALL);
    }
    return settings;
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    Rng rng = new Rng(request.seed()).fork(name());
    String scenario = scenario(request);
    String prefix = settings.robotName();
    Obstacles obstacles = Floor.kerbs();
    List<Car> cars = List.of();
    switch (scenario) {
      case OPEN -> checkOpen(request, settings);
      case DRAWN, FIGURE7 ->
          cars =
              IntersectionFactory.cars(request, prefix, request.robots().orElse(settings.robots()));
      case "legacy" -> {
        LegacyFiles files = LegacyFiles.read(request.parameter(FILES.key()));
        cars = files.cars();
        obstacles = files.obstacles();
      }
      default ->
          throw new BadInput(
              "scenario=" + BadInput.quote(scenario) + ": expected drawn, figure7, legacy or open");
    }
    boolean isOpen = scenario.equals(OPEN);
    int given = request.robots().orElse(cars.size());
    if (!isOpen && given != cars.size()) {
      throw new BadInput("robots: " + given + ": expected " + cars.size() + " for " + scenario);
    }
    int pieces = IntersectionFactory.debris(request);
    Obstacles floor = Floor.withDebris(obstacles, pieces, rng.fork("debris"));
    IntersectionPlan plan = new IntersectionPlan(floor, settings, CarProgram.of(request));
    return isOpen
        ? plan.open(
            rateHz(request), request.robots().orElse(Integer.MAX_VALUE), rng.fork("arrivals"))
        : plan.closed(cars);
  }

  /**
   * An open road with cars of another program, without specifications, for comparisons.
   *
   * @param rateHz average number of cars that arrive per second, on all arms together; above 0
   */
  public static Plan openRoad(CarMaker car, double rateHz, SimSettings settings, long seed) {
    return new IntersectionPlan(Floor.kerbs(), settings, car)
        .openUnchecked(rateHz, arrivalsRng(seed));
  }

  /** The cars that arrive on {@link #openRoad} within a time, for other simulators. */
  public static List<Car> arrivals(double rateHz, Duration within, long seed) {
    long untilNs = within.toNanos();
    return new Arrivals(rateHz, untilNs, Integer.MAX_VALUE, "car", arrivalsRng(seed))
        .until(untilNs);
  }

  private static Rng arrivalsRng(long seed) {
    return new Rng(seed).fork(FACTORY.name()).fork("arrivals");
  }

  /** The scenario; {@code open} if the user gives arrivals and no scenario. */
  private static String scenario(Request request) {
    String scenario = request.parameter(SCENARIO.key());
    if (request.parameter(ARRIVALS.key()).isEmpty() || scenario.equals(OPEN)) {
      return scenario;
    }
    if (!scenario.equals(SCENARIO.defaultValue())) {
      throw new BadInput("arrivals with scenario=" + scenario + ": expected scenario=" + OPEN);
    }
    return OPEN;
  }

  private static void checkOpen(Request request, SimSettings settings) {
    if (request.robots().orElse(1) < 1) {
      throw new BadInput("robots: 0: expected at least 1 on an open road");
    }
    if (settings.endNs() > MAX_ARRIVALS_NS) {
      throw new BadInput(
          "duration: expected from 1ms to 1000h with scenario=open, where cars arrive until then");
    }
  }

  private static double rateHz(Request request) {
    return request.parse(
        ARRIVALS,
        text -> {
          double rateHz = Quantities.rateHz(text.isEmpty() ? DEFAULT_ARRIVALS : text);
          if (rateHz > MAX_ARRIVALS_HZ) {
            throw new BadInput(BadInput.quote(text) + ": expected at most 600/min");
          }
          return rateHz;
        });
  }
}

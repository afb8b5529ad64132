package org.starl.apps.fleet;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.fleet.files.Deliveries;
import org.starl.apps.fleet.files.NavGraphs;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.Roads;
import org.starl.apps.fleet.robot.FleetFactory;
import org.starl.apps.fleet.spec.FleetSpec;
import org.starl.apps.fleet.view.FleetLayer;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.TextFile;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.world.GridMap;
import org.starl.sim.world.GridTrips;
import org.starl.time.Time;

/** {@code starl run fleet}. */
public final class FleetDemo implements FactoryDemo {

  private static final FleetFactory FACTORY = new FleetFactory();
  private static final int ROBOTS = 8;

  // Of a list that counts steps: the time for a lane of the built-in warehouse.
  private static final long STEP_MS = 6_000;

  // A robot that has the floor for itself drives a delivery faster.
  private static final double SLOWEST_MM_PER_S = 100;
  private static final long HANDLING_NS = 60 * Time.NS_PER_S;

  // Loads are put down in it: the first one after a minute or two.
  private static final Duration CHAOS = Duration.ofMinutes(4);

  @Override
  public AppFactory factory() {
    return FACTORY;
  }

  @Override
  public String summary() {
    return "robots deliver loads along the lanes of a warehouse, without a dispatcher";
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public Request varied(Request request) {
    // With the default range no robot has to charge, which takes time; so there is less to do.
    return request
        .drawRobots(2, 12)
        .drawParameter(FleetFactory.RANGE, "160m")
        .drawParameter(FleetFactory.DELIVERIES, "12");
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    int robots = request.robots().orElse(ROBOTS);
    Job job = job(request, robots);
    double bodyMm = SimSettings.defaults().robotRadiusMm();
    Roads roads = FleetFactory.roads(job.graph, bodyMm, robots);
    List<Delivery> deliveries = job.deliveries;
    long lastNs = deliveries.get(deliveries.size() - 1).atNs() + boundNs(roads, deliveries);
    return SimSettings.builder()
        .set(Setting.ROBOTS, robots)
        .set(Setting.CHAOS_FOR, CHAOS)
        .set(Setting.DURATION.key(), lastNs / Time.NS_PER_S + 1 + "s");
  }

  /** Of a file, or built in. */
  private static NavGraph graph(Request request, int robots) {
    FleetFactory.checkRobots(robots);
    String file = request.parameter(FleetFactory.MAP.key());
    if (file.isEmpty()) {
      return FleetFactory.grid(robots);
    }
    NavGraphs.Choice choice =
        new NavGraphs.Choice(
            request.parameter(FleetFactory.LEVEL.key()),
            request.whole(FleetFactory.GRAPH),
            request.amount(FleetFactory.SPACING),
            request.amount(FleetFactory.CLEARANCE));
    return NavGraphs.read(Path.of(file), choice);
  }

  /** Deliveries, between stations of a graph. */
  private record Job(NavGraph graph, List<Delivery> deliveries) {}

  private static Job job(Request request, int robots) {
    NavGraph graph = graph(request, robots);
    String file = request.parameter(FleetFactory.TASKS.key());
    if (file.isEmpty()) {
      return new Job(graph, FleetFactory.drawn(request, graph));
    }
    Path tasks = Path.of(file);
    String map = request.parameter(FleetFactory.MAP.key());
    Optional<GridMap> grid = map.isEmpty() ? Optional.empty() : NavGraphs.gridMap(Path.of(map));
    if (grid.isEmpty() || !GridTrips.isList(TextFile.read(tasks, "expected deliveries"))) {
      return new Job(graph, Deliveries.read(tasks, graph, STEP_MS));
    }
    int most = request.whole(FleetFactory.DELIVERIES);
    List<Delivery> trips = Deliveries.ofTrips(tasks, grid.get(), graph, most);
    Set<Integer> ends = new TreeSet<>();
    trips.forEach(trip -> ends.addAll(List.of(trip.pick(), trip.drop())));
    return new Job(NavGraphs.withStations(graph, ends), trips);
  }

  /** Even if the robots did all deliveries one after the other. */
  private static long boundNs(Roads roads, List<Delivery> deliveries) {
    long oneNs = (long) (Time.NS_PER_S * roads.longestMm() / SLOWEST_MM_PER_S) + HANDLING_NS;
    return (deliveries.size() + 1) * oneNs;
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    int robots = request.robots().orElse(settings.robots());
    Job job = job(request, robots);
    Roads roads = FleetFactory.roads(job.graph, settings.robotRadiusMm(), robots);
    List<Delivery> deliveries = job.deliveries;
    double rangeMm = FleetFactory.rangeMm(request, roads);
    FleetStory story = new FleetStory(deliveries);
    Simulation.Builder simulation =
        Simulation.builder().settings(settings).observer(story).obstacles(job.graph.walls());
    Set<String> broken = FleetFactory.broken(request);
    List<String> names = ids(settings, robots).stream().map(RobotId::toString).toList();
    for (String name : broken) {
      if (!names.contains(name)) {
        throw new BadInput(
            FleetFactory.BROKEN.key()
                + ": "
                + BadInput.quote(name)
                + ": expected robots of this run, such as bot1+bot2");
      }
    }
    RobotProgram program = FleetFactory.program(roads, deliveries, rangeMm, broken);
    fill(simulation, robots, roads, deliveries, program, boundNs(roads, deliveries));
    return new Plan(simulation, story, new FleetLayer(roads, deliveries), simulation.obstacles());
  }

  private static List<RobotId> ids(SimSettings settings, int robots) {
    return IntStream.range(0, robots).mapToObj(i -> new RobotId(settings.robotName() + i)).toList();
  }

  /** Adds robots at their homes, and their monitors. */
  static void fill(
      Simulation.Builder simulation,
      int robots,
      Roads roads,
      List<Delivery> deliveries,
      RobotProgram program,
      long boundNs) {
    List<RobotId> all = ids(simulation.settings(), robots);
    List<RobotId> byName = all.stream().sorted().toList();
    for (RobotId id : all) {
      Point home = roads.at(roads.home(byName.indexOf(id)));
      Pose start = new Pose(home.xMm(), home.yMm(), 0);
      simulation.robot(new RobotSpec(id, start, true, program.app()));
    }
    simulation.monitor(() -> new FleetSpec(roads, deliveries, boundNs));
    program.monitors().forEach(simulation::monitor);
  }
}

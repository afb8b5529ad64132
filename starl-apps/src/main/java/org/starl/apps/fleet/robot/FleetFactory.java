package org.starl.apps.fleet.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.FleetApp;
import org.starl.apps.fleet.logic.FleetFact;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.Roads;
import org.starl.body.MotionParameters;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantity;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.random.Rng;
import org.starl.trace.Vocabulary;

/** Robots that deliver in the built-in warehouse. */
public final class FleetFactory implements AppFactory {

  public static final Parameter DELIVERIES =
      new Parameter("deliveries", "16", "number of deliveries", Form.whole(1, 10_000));
  public static final Parameter RATE =
      new Parameter(
          "rate",
          "200",
          "deliveries asked for in an hour, on average, at times drawn from the seed",
          Form.whole(1, 100_000));
  public static final Parameter RANGE =
      new Parameter(
          "range",
          "500m",
          "way of a robot on one charge, at least three times its longest way; without chargers no"
              + " effect",
          Form.between(Quantity.DISTANCE, "10m", "100000m"));

  public static final Parameter MAP =
      new Parameter(
          "map",
          "",
          "file of a building of Open-RMF, of a map of map_server or Nav2, or a grid map; without one: the"
              + " built-in warehouse");
  public static final Parameter LEVEL =
      new Parameter("level", "", "level of the building; without one: the first with lanes");
  public static final Parameter GRAPH =
      new Parameter(
          "graph",
          "-1",
          "graph_idx of the level's lanes; -1: that of most lanes",
          Form.whole(-1, 1_000));
  public static final Parameter SPACING =
      new Parameter(
          "spacing",
          "1m",
          "between neighbouring places on a map; on a grid map: the side of a cell",
          Form.between(Quantity.DISTANCE, "100mm", "100m"));
  public static final Parameter CLEARANCE =
      new Parameter(
          "clearance",
          "250mm",
          "from places and lanes to walls on a map",
          Form.between(Quantity.DISTANCE, "0m", "10m"));
  public static final Parameter TASKS =
      new Parameter(
          "tasks",
          "",
          "file of deliveries, or of starts and goals on a grid map (.scen); without one: drawn from the seed");

  public static final Parameter BROKEN =
      new Parameter(
          "broken",
          "",
          "robots that do not drive any more, with + between them: programs that start anew on these only tell"
              + " where they stand");

  private static final int MOST_ROBOTS = 1_000;
  private static final double RESERVE = 3;

  @Override
  public String name() {
    return "fleet";
  }

  @Override
  public Vocabulary vocabulary(Request request) {
    return FleetFact.VOCABULARY;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(DELIVERIES, RATE, RANGE, MAP, LEVEL, GRAPH, SPACING, CLEARANCE, TASKS, BROKEN);
  }

  @Override
  public RobotProgram program(Request request) {
    request.refuseOnRobots(MAP);
    request.refuseOnRobots(TASKS);
    int robots = request.robots().orElse(1);
    NavGraph graph = grid(robots);
    Roads roads = roads(graph, MotionParameters.DEFAULT.robotRadiusMm(), robots);
    return program(roads, drawn(request, graph), rangeMm(request, roads), broken(request));
  }

  /** The names of the robots of {@link #BROKEN}. */
  public static Set<String> broken(Request request) {
    String names = request.parameter(BROKEN.key());
    return names.isEmpty() ? Set.of() : Set.copyOf(List.of(names.split("\\+", -1)));
  }

  /** The program of the robots of this fleet. */
  public static RobotProgram program(
      Roads roads, List<Delivery> deliveries, double rangeMm, Set<String> broken) {
    return RobotProgram.of(gvh ->
            new FleetApp(
                gvh, roads, deliveries, rangeMm, broken.contains(gvh.id.name().toString())))
        .withMonitor(MutexSpec::new)
        .withMonitor(LedgerSpec::new);
  }

  /**
   * The built-in warehouse.
   *
   * @throws BadInput if a fleet has not so many robots
   */
  public static NavGraph grid(int robots) {
    checkRobots(robots);
    return GridWarehouse.of(robots);
  }

  /** @throws BadInput if a fleet has not so many robots */
  public static void checkRobots(int robots) {
    if (robots < 1 || robots > MOST_ROBOTS) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + MOST_ROBOTS + " in a fleet");
    }
  }

  /**
   * Sections and ways for robots of this radius.
   *
   * @throws BadInput if the map has not room for so many robots, or not all ways that they need
   */
  public static Roads roads(NavGraph graph, double bodyMm, int robots) {
    try {
      return new Roads(graph, bodyMm, robots);
    } catch (IllegalArgumentException e) {
      throw new BadInput("map: " + e.getMessage());
    }
  }

  /**
   * The value of {@link #RANGE}; 0 on a map without chargers.
   *
   * @throws BadInput if a robot could not come home to charge
   */
  public static double rangeMm(Request request, Roads roads) {
    double rangeMm = request.amount(RANGE);
    if (!roads.hasChargers()) {
      return 0;
    }
    if (rangeMm < RESERVE * roads.longestMm()) {
      long leastM = (long) StrictMath.ceil(RESERVE * roads.longestMm() / 1_000);
      throw new BadInput(
          RANGE.key()
              + "="
              + BadInput.quote(request.parameter(RANGE.key()))
              + ": expected at least "
              + leastM
              + "m, three times the longest way of a robot on this map");
    }
    return rangeMm;
  }

  /**
   * Deliveries between stations, at times, all drawn from the seed.
   *
   * @throws BadInput if the map has fewer than two stations
   */
  public static List<Delivery> drawn(Request request, NavGraph graph) {
    List<Integer> stations = graph.stations();
    if (stations.size() < 2) {
      throw new BadInput("map: " + stations.size() + " stations: expected at least 2");
    }
    Rng rng = new Rng(request.seed()).fork("fleet");
    double meanMs = 3_600_000.0 / request.whole(RATE);
    List<Delivery> deliveries = new ArrayList<>();
    double ms = 0;
    for (int i = 0; i < request.whole(DELIVERIES); i++) {
      ms -= meanMs * StrictMath.log(1 - rng.nextDouble());
      int pick = (int) (rng.nextDouble() * stations.size());
      int further = 1 + (int) (rng.nextDouble() * (stations.size() - 1));
      int drop = (pick + further) % stations.size();
      deliveries.add(new Delivery((long) ms, stations.get(pick), stations.get(drop)));
    }
    return deliveries;
  }
}

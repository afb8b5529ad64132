package org.starl.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.fleet.FleetDemo;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.Roads;
import org.starl.apps.fleet.robot.FleetFactory;
import org.starl.body.MotionParameters;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;

/**
 * {@code starl bench fleet}: deliveries an hour of the app fleet, and of a central planner ({@link
 * TokenPassing}) on the same map with the same deliveries, all of which are open from the start. The
 * planner has the robots' speed and handling time, but neither turns, brakes nor charges, and loses no
 * message. Its lanes have whole numbers of cells, so it is faster on some than the robots are.
 */
public final class FleetRates {

  /** Name in {@code starl bench NAME}. */
  public static final String NAME = "fleet";

  /** One line for people. */
  public static final String SUMMARY =
      "deliveries an hour of 2, 4, 8, ... robots, by the app fleet and by a central planner";

  /** What happens to a run of the fleet. */
  private enum Fault {
    NONE("none", 0),
    SOME_LOSS("loss 0.1", 0.1),
    MUCH_LOSS("loss 0.3", 0.3),
    CRASHES("a crash a minute", 0);

    private final String text;
    private final double loss;

    Fault(String text, double loss) {
      this.text = text;
      this.loss = loss;
    }

    /** Each robot that crashes starts again after ten seconds. */
    private List<String> faults(SimSettings settings) {
      long minutes = this == CRASHES ? settings.get(Setting.DURATION).toMinutes() : 0;
      return LongStream.rangeClosed(1, minutes)
          .mapToObj(minute -> "crash(any,at=" + 60 * minute + "s,restart=10s)")
          .toList();
    }
  }

  private static final int DELIVERIES_A_ROBOT = 4;

  /** An hour: far more than robots deliver. */
  private static final String RATE = "100000";

  /** Between bodies, besides two radii, as the app keeps it. */
  private static final double SLACK_MM = 100;

  private static final long HANDLE_MS = 2000;

  /** Deliveries an hour of one run. */
  private interface Dispatch {
    double anHour(Request request);
  }

  private FleetRates() {}

  /** The number of rows up to so many robots. */
  public static int rows(int mostRobots) {
    return (int) sizes(mostRobots).count() * (1 + Fault.values().length);
  }

  /**
   * Rows for 2 robots, for 4, 8, and so on, and for {@code mostRobots}: the central planner, and the
   * fleet with losses and crashes; the means of {@code runs} runs, of the seeds from {@code seed} on.
   *
   * @param afterRow called with the number of rows so far
   */
  public static List<Map<String, Object>> take(
      int mostRobots, long seed, int runs, IntConsumer afterRow) {
    List<Map<String, Object>> rows = new ArrayList<>();
    for (int robots : sizes(mostRobots).toArray()) {
      rows.add(row(robots, "central", Fault.NONE, seed, runs, FleetRates::central));
      afterRow.accept(rows.size());
      for (Fault fault : Fault.values()) {
        rows.add(row(robots, "fleet", fault, seed, runs, request -> fleet(request, fault)));
        afterRow.accept(rows.size());
      }
    }
    return rows;
  }

  private static IntStream sizes(int most) {
    return IntStream.concat(
        IntStream.iterate(2, robots -> robots < most, robots -> 2 * robots), IntStream.of(most));
  }

  private static Map<String, Object> row(
      int robots, String name, Fault fault, long seed, int runs, Dispatch dispatch) {
    double sum = 0;
    for (int i = 0; i < runs; i++) {
      sum += dispatch.anHour(request(robots, seed + i));
    }
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("robots", robots);
    row.put("dispatch", name);
    row.put("faults", fault.text);
    row.put("deliveries_an_hour", sum / runs);
    return row;
  }

  private static Request request(int robots, long seed) {
    SortedMap<String, String> given = new TreeMap<>();
    given.put(FleetFactory.DELIVERIES.key(), "" + DELIVERIES_A_ROBOT * robots);
    given.put(FleetFactory.RATE.key(), RATE);
    return new Request(
        seed,
        OptionalInt.of(robots),
        Parameter.values(new FleetDemo().parameters(), given),
        given.keySet());
  }

  static double central(Request request) {
    int robots = request.robots().orElseThrow();
    NavGraph graph = FleetFactory.grid(robots);
    MotionParameters motion = MotionParameters.DEFAULT;
    Roads roads = FleetFactory.roads(graph, motion.robotRadiusMm(), robots);
    List<Delivery> deliveries = FleetFactory.drawn(request, graph);
    return new TokenPassing(
            graph,
            IntStream.range(0, robots).mapToObj(roads::home).toList(),
            // Where a robot turns off, the next one is a diagonal away.
            StrictMath.sqrt(2) * (2 * motion.robotRadiusMm() + SLACK_MM),
            motion.linSpeedMaxMmPerS(),
            HANDLE_MS)
        .plan(deliveries)
        .anHour();
  }

  private static double fleet(Request request, Fault fault) {
    FleetDemo demo = new FleetDemo();
    SimSettings settings =
        demo.defaultSettings(request).set(Setting.MESSAGE_LOSS, fault.loss).build();
    Plan plan = demo.plan(request, settings);
    fault.faults(settings).forEach(plan.simulation()::fault);
    plan.simulation().name(NAME).seed(request.seed()).build().run();
    return plan.story().measures().figures().getOrDefault("deliveries_an_hour", 0.0);
  }
}

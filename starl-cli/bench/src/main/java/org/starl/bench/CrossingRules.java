package org.starl.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.function.UnaryOperator;
import org.starl.GlobalVarHolder;
import org.starl.apps.Measures;
import org.starl.apps.Plan;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.robot.CarMaker;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/**
 * B4a: the intersection of the paper's Figure 2 as an open road, with rules for when a car may enter:
 * StarL's mutex over the sequence of zones that a car needs, over their set, one lock for the whole
 * intersection, and a four-way stop. The arrivals (a Poisson process over the four arms and twelve
 * routes), the queues on the arms and the registration are the same.
 */
public final class CrossingRules {

  /** Name in {@code starl bench NAME}. */
  public static final String NAME = "b4a";

  /** One line for people. */
  public static final String SUMMARY =
      "cars a minute and delays at an intersection: zones in sequence, sets of zones, one lock,"
          + " four-way stop";

  /** Average arrivals a minute, on all arms together. The last is more than any rule serves. */
  static final int[] RATES = {4, 8, 12, 20, 60};

  /** At this rate {@link Rule#FLOW} also runs with faults. */
  private static final int FAULTY_RATE = 8;

  private static final List<String> NONE = List.of();

  /** Lost messages, robots that crash and restart, and robots that neither hear nor speak. */
  private static final List<List<String>> FAULTS =
      List.of(
          List.of("loss(0.2)"),
          List.of("loss(0.5)"),
          Collections.nCopies(3, "crash(any,at=60s..500s,restart=5s)"),
          Collections.nCopies(3, "partition(any,at=60s..500s,for=20s)"));

  private static final Optional<Sumo> SUMO = Sumo.find();

  /** A rule for when a car may enter. */
  enum Rule {
    FLOW,
    PAPER,
    LOCK,
    STOP;

    private CarMaker car(StopSign.Junction junction) {
      return switch (this) {
        case FLOW -> CarProgram.FLOW;
        case PAPER -> CarProgram.PAPER;
        case LOCK -> asPaper(gvh -> OneLock::new);
        case STOP -> asPaper(gvh -> mutex -> new StopSign(gvh, junction));
      };
    }

    private static CarMaker asPaper(Function<GlobalVarHolder, UnaryOperator<MutexPrim>> rule) {
      return (gvh, trip, acceptors) ->
          new IntersectionApp(gvh, IntersectionFactory.XID, trip, acceptors, rule.apply(gvh));
    }
  }

  /**
   * One run.
   *
   * @param inTime cars that crossed while cars arrived
   * @param delayMeanS of all cars that arrived, over a free road
   * @param completed cars that crossed
   * @param shortestWaitNs the shortest wait of a car before the crossing
   */
  record Flow(
      double arrived,
      double inTime,
      double delayMeanS,
      double turnedAway,
      long contacts,
      int completed,
      long shortestWaitNs) {}

  private CrossingRules() {}

  /**
   * A row for each rate of arrivals and rule, for each rate and control of SUMO if that is on the
   * PATH, and for {@link Rule#FLOW} with faults: the sums of {@code runs} runs, of the seeds from
   * {@code seed} on, with arrivals for {@code arrivals}.
   *
   * @param afterRow called with the number of rows so far
   */
  public static List<Map<String, Object>> take(
      Duration arrivals, long seed, int runs, IntConsumer afterRow) {
    List<Map<String, Object>> rows = new ArrayList<>();
    for (int rate : RATES) {
      for (Rule rule : Rule.values()) {
        rows.add(row(rule, rate, NONE, arrivals, seed, runs));
        afterRow.accept(rows.size());
      }
      if (SUMO.isPresent()) {
        for (Sumo.Control control : Sumo.Control.values()) {
          rows.add(row(SUMO.get(), control, rate, arrivals, seed, runs));
          afterRow.accept(rows.size());
        }
      }
    }
    for (List<String> faults : FAULTS) {
      rows.add(row(Rule.FLOW, FAULTY_RATE, faults, arrivals, seed, runs));
      afterRow.accept(rows.size());
    }
    return rows;
  }

  /** The number of rows. */
  public static int rows() {
    int sumo = hasSumo() ? Sumo.Control.values().length : 0;
    return RATES.length * (Rule.values().length + sumo) + FAULTS.size();
  }

  /** Whether SUMO's programs are on the PATH. */
  public static boolean hasSumo() {
    return SUMO.isPresent();
  }

  private static Map<String, Object> row(
      Rule rule, int ratePerMin, List<String> faults, Duration arrivals, long seed, int runs) {
    Sums sums = new Sums();
    for (int i = 0; i < runs; i++) {
      sums.add(run(rule, ratePerMin, faults, arrivals, seed + i));
    }
    return sums.row(ratePerMin, faults, rule.name().toLowerCase(Locale.ROOT), arrivals, runs);
  }

  private static Map<String, Object> row(
      Sumo sumo, Sumo.Control control, int rate, Duration arrivals, long seed, int runs) {
    Sums sums = new Sums();
    for (int i = 0; i < runs; i++) {
      sums.add(sumo.run(control, rate, arrivals, seed + i));
    }
    String name = "sumo " + control.name().toLowerCase(Locale.ROOT);
    return sums.row(rate, NONE, name, arrivals, runs);
  }

  static Flow run(Rule rule, int ratePerMin, List<String> faults, Duration arrivals, long seed) {
    SimSettings settings =
        SimSettings.builder().floorHeight(5000).floorWidth(5000).duration(arrivals).build();
    Plan plan =
        IntersectionDemo.openRoad(
            rule.car(new StopSign.Junction()), ratePerMin / 60.0, settings, seed);
    Simulation.Builder simulation = plan.simulation().name(NAME).seed(seed);
    faults.forEach(simulation::fault);
    SimResult result = simulation.build().run();
    Measures measures = plan.story().measures();
    return new Flow(
        figure(measures, "arrived"),
        figure(measures, "crossed_in_time"),
        figure(measures, "delay_mean_s"),
        figure(measures, "turned_away"),
        result.collisions().ofRobots(),
        measures.completed(),
        measures.waitsNs().stream().mapToLong(Long::longValue).min().orElse(0));
  }

  private static double figure(Measures measures, String name) {
    return measures.figures().getOrDefault(name, 0.0);
  }

  /** The sums of some runs. */
  private static final class Sums {

    private double arrived;
    private double inTime;
    private double delayS;
    private double away;
    private long contacts;

    void add(Flow flow) {
      arrived += flow.arrived();
      inTime += flow.inTime();
      delayS += flow.arrived() * flow.delayMeanS();
      away += flow.turnedAway();
      contacts += flow.contacts();
    }

    Map<String, Object> row(
        int ratePerMin, List<String> faults, String rule, Duration arrivals, int runs) {
      Map<String, Object> row = new LinkedHashMap<>();
      row.put("arrivals_per_min", ratePerMin);
      row.put("faults", String.join(" ", faults));
      row.put("rule", rule);
      row.put("arrived", (int) arrived);
      row.put("crossed_in_time_per_min", 60 * inTime / runs / arrivals.toSeconds());
      row.put("delay_mean_s", delayS / Math.max(1, arrived));
      row.put("turned_away", (int) away);
      row.put("contacts", contacts);
      return row;
    }
  }
}

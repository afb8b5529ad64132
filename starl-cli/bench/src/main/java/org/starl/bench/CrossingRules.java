package org.starl.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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

  /** At this rate {@link Rule#FLOW} also runs with lost messages. */
  private static final int LOSSY_RATE = 8;

  private static final double[] LOSSES = {0.2, 0.5};

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

  /** One run. */
  record Flow(Measures measures, long contacts) {
    double figure(String name) {
      return measures.figures().getOrDefault(name, 0.0);
    }
  }

  private CrossingRules() {}

  /**
   * A row for each rate of arrivals and rule, and for {@link Rule#FLOW} with loss: the sums of
   * {@code runs} runs, of the seeds from {@code seed} on, with arrivals for {@code arrivals}.
   *
   * @param afterRow called with the number of rows so far
   */
  public static List<Map<String, Object>> take(
      Duration arrivals, long seed, int runs, IntConsumer afterRow) {
    List<Map<String, Object>> rows = new ArrayList<>();
    for (int rate : RATES) {
      for (Rule rule : Rule.values()) {
        rows.add(row(rule, rate, 0, arrivals, seed, runs));
        afterRow.accept(rows.size());
      }
    }
    for (double loss : LOSSES) {
      rows.add(row(Rule.FLOW, LOSSY_RATE, loss, arrivals, seed, runs));
      afterRow.accept(rows.size());
    }
    return rows;
  }

  /** The number of rows. */
  public static int rows() {
    return RATES.length * Rule.values().length + LOSSES.length;
  }

  private static Map<String, Object> row(
      Rule rule, int ratePerMin, double loss, Duration arrivals, long seed, int runs) {
    double arrived = 0;
    double inTime = 0;
    double delayS = 0;
    double away = 0;
    long contacts = 0;
    for (int i = 0; i < runs; i++) {
      Flow flow = run(rule, ratePerMin, loss, arrivals, seed + i);
      arrived += flow.figure("arrived");
      inTime += flow.figure("crossed_in_time");
      delayS += flow.figure("arrived") * flow.figure("delay_mean_s");
      away += flow.figure("turned_away");
      contacts += flow.contacts();
    }
    Map<String, Object> row = new LinkedHashMap<>();
    row.put("arrivals_per_min", ratePerMin);
    row.put("loss", loss);
    row.put("rule", rule.name().toLowerCase(Locale.ROOT));
    row.put("arrived", (int) arrived);
    row.put("crossed_in_time_per_min", 60 * inTime / runs / arrivals.toSeconds());
    row.put("delay_mean_s", delayS / Math.max(1, arrived));
    row.put("turned_away", (int) away);
    row.put("contacts", contacts);
    return row;
  }

  static Flow run(Rule rule, int ratePerMin, double loss, Duration arrivals, long seed) {
    SimSettings settings =
        SimSettings.builder()
            .floorHeight(5000)
            .floorWidth(5000)
            .messageLoss(loss)
            .duration(arrivals)
            .build();
    Plan plan =
        IntersectionDemo.openRoad(
            rule.car(new StopSign.Junction()), ratePerMin / 60.0, settings, seed);
    SimResult result = plan.simulation().name(NAME).seed(seed).build().run();
    return new Flow(plan.story().measures(), result.collisions().ofRobots());
  }
}

package org.starl.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntConsumer;
import java.util.function.UnaryOperator;
import org.starl.GlobalVarHolder;
import org.starl.apps.Measures;
import org.starl.apps.Plan;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.check.Percentile;
import org.starl.time.Time;

/**
 * B4a: the intersection of the paper's Figure 2 as an open road, with three rules for who may enter:
 * StarL's mutex over the set of zones that a car needs, one lock for the whole intersection, and a
 * four-way stop. The arrivals (a Poisson process over the four arms and twelve routes), the motion,
 * the queues on the arms and the registration are the same.
 */
public final class CrossingRules {

  /** Name in {@code starl bench NAME}. */
  public static final String NAME = "b4a";

  /** One line for people. */
  public static final String SUMMARY =
      "cars a minute and waits at an intersection: mutex over zones, one lock, four-way stop";

  /** Average arrivals a minute, on all arms together. */
  static final int[] RATES = {4, 8, 12, 20};

  /** A rule for who may enter. */
  enum Rule {
    MUTEX,
    LOCK,
    STOP;

    private UnaryOperator<MutexPrim> of(GlobalVarHolder gvh, StopSign.Junction junction) {
      return switch (this) {
        case MUTEX -> mutex -> mutex;
        case LOCK -> OneLock::new;
        case STOP -> mutex -> new StopSign(gvh, junction);
      };
    }
  }

  /**
   * @param waitsS time from a car's arrival to the grant of its zones, sorted, in s
   */
  record Flow(int arrived, int crossed, double crossedPerMin, List<Double> waitsS, long contacts) {}

  private CrossingRules() {}

  /**
   * A row for each rate of arrivals and rule, with arrivals for {@code arrivals}.
   *
   * @param afterRow called with the number of rows so far
   */
  public static List<Map<String, Object>> take(Duration arrivals, long seed, IntConsumer afterRow) {
    List<Map<String, Object>> rows = new ArrayList<>();
    for (int rate : RATES) {
      for (Rule rule : Rule.values()) {
        Flow flow = run(rule, rate, arrivals, seed);
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("arrivals_per_min", rate);
        row.put("rule", rule.name().toLowerCase(Locale.ROOT));
        row.put("arrived", flow.arrived());
        row.put("crossed", flow.crossed());
        row.put("crossed_per_min", flow.crossedPerMin());
        row.put("wait_median_s", percentile(flow.waitsS(), 50));
        row.put("wait_95_s", percentile(flow.waitsS(), 95));
        row.put("contacts", flow.contacts());
        rows.add(row);
        afterRow.accept(rows.size());
      }
    }
    return rows;
  }

  /** The number of rows. */
  public static int rows() {
    return RATES.length * Rule.values().length;
  }

  static Flow run(Rule rule, int ratePerMin, Duration arrivals, long seed) {
    SimSettings settings =
        SimSettings.builder().floorHeight(5000).floorWidth(5000).duration(arrivals).build();
    StopSign.Junction junction = new StopSign.Junction();
    Plan plan =
        IntersectionDemo.openRoad(
            (gvh, trip, acceptors) ->
                new IntersectionApp(
                    gvh, IntersectionFactory.XID, trip, acceptors, rule.of(gvh, junction)),
            ratePerMin / 60.0,
            settings,
            seed);
    SimResult result = plan.simulation().name(NAME).seed(seed).build().run();
    Measures measures = plan.story().measures();
    return new Flow(
        measures.figures().getOrDefault("arrived", 0.0).intValue(),
        measures.completed(),
        measures.figures().getOrDefault("crossed_per_min", 0.0),
        measures.waitsNs().stream().map(Time::seconds).sorted().toList(),
        result.collisions().ofRobots());
  }

  private static double percentile(List<Double> sorted, int percent) {
    return sorted.isEmpty() ? 0 : sorted.get(Percentile.index(sorted.size(), percent));
  }
}

package org.starl.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.check.Percentile;
import org.starl.sim.net.Latency;
import org.starl.time.Time;

/**
 * {@code starl bench mutex}: the cost of an entry into a section in a group of N robots, in virtual
 * time and messages, compared with theory. Every message takes delta, none is lost; every robot
 * enters the same section once and releases it after d1.
 *
 * <ul>
 *   <li><b>Free</b>: one robot after the other, so that the section is free. Theory: 2 delta, N - 1
 *       requests, as many answers, and as many releases.
 *   <li><b>Busy</b>: all at the same time. Theory: the last one enters after at most (N - 1)(d1 + 2
 *       delta) + 2 delta. A robot that waits longer than the first resend period repeats its
 *       request, which is acknowledged: these are the messages beyond 3 (N - 1).
 * </ul>
 */
public final class MutexCost {

  /** Name in {@code starl bench NAME}. */
  public static final String NAME = "mutex";

  /** One line for people. */
  public static final String SUMMARY =
      "messages and time per entry, 2 to 64 robots, compared with theory";

  /** Delta: the delay of every message. */
  private static final long DELTA_MS = 10;

  /** d1: how long every robot holds the section. */
  private static final long HOLD_MS = 100;

  private static final String SECTION = "A";

  private MutexCost() {}

  /**
   * A row for 2 robots, for 4, 8, and so on, up to {@code mostRobots}; calls {@code afterRow} after
   * each.
   *
   * @return for each row its figures in display order; those with {@code theory} or {@code bound}
   *     in their names are computed, the others are measured
   */
  public static List<Map<String, Object>> take(int mostRobots, long seed, IntConsumer afterRow) {
    List<Map<String, Object>> rows = new ArrayList<>();
    for (int robots = 2; robots <= mostRobots; robots *= 2) {
      // So far apart that each robot finds the section free and no message under way.
      Entries free = enter(robots, HOLD_MS + 10 * DELTA_MS, seed);
      Entries busy = enter(robots, 0, seed);
      Map<String, Object> row = new LinkedHashMap<>();
      row.put("n", robots);
      row.put("free_ms", free.percentileMs(100));
      row.put("free_theory_ms", 2.0 * DELTA_MS);
      row.put("free_messages", free.messagesEach());
      row.put("messages_theory", 3.0 * (robots - 1));
      row.put("busy_median_ms", busy.percentileMs(50));
      row.put("busy_most_ms", busy.percentileMs(100));
      row.put("busy_bound_ms", (robots - 1.0) * (HOLD_MS + 2 * DELTA_MS) + 2 * DELTA_MS);
      row.put("busy_messages", busy.messagesEach());
      rows.add(row);
      afterRow.accept(rows.size());
    }
    return rows;
  }

  private record Entries(List<Long> sortedWaitsNs, long messages) {

    double percentileMs(int percent) {
      long ns = sortedWaitsNs.get(Percentile.index(sortedWaitsNs.size(), percent));
      return ns / (double) Time.NS_PER_MS;
    }

    double messagesEach() {
      return (double) messages / sortedWaitsNs.size();
    }
  }

  /** Each robot enters once, robot {@code i} asking at {@code i} times {@code apartMs}. */
  private static Entries enter(int robots, long apartMs, long seed) {
    SimSettings settings =
        SimSettings.builder()
            .set(Setting.MESSAGE_DELAY, new Latency.Constant(DELTA_MS * Time.NS_PER_MS))
            .build();
    Simulation.Builder simulation = Simulation.builder().name(NAME).seed(seed).settings(settings);
    for (int i = 0; i < robots; i++) {
      long askMs = i * apartMs;
      RobotId id = new RobotId("bot" + i);
      // Without bodies: only messages cause events.
      simulation.robot(new RobotSpec(id, new Pose(0, 0, 0), false, gvh -> new Entrant(gvh, askMs)));
    }
    SimResult result = simulation.build().run();
    List<Long> waitsNs = new ArrayList<>();
    result.results().values().forEach(ended -> waitsNs.add((Long) ended.get(0)));
    waitsNs.sort(Long::compare);
    return new Entries(waitsNs, result.network().sent());
  }

  /** Enters once; its result is how long it waited, in ns. */
  private static final class Entrant extends LogicThread {
    private final M_Mutex mux;
    private final long askMs;

    Entrant(GlobalVarHolder gvh, long askMs) {
      super(gvh);
      this.askMs = askMs;
      mux = new M_Mutex(gvh, "section", gvh.id.participants());
    }

    @Override
    public List<Object> callStarL() {
      sleep(askMs);
      long askedNs = gvh.plat.clock.nowNs();
      mux.do_mutex(List.of(SECTION));
      await(() -> mux.crit().get());
      long waitedNs = gvh.plat.clock.nowNs() - askedNs;
      sleep(HOLD_MS);
      mux.release(SECTION);
      return List.of(waitedNs);
    }
  }
}

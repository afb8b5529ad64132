package org.starl.sim;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.RobotId;

/**
 * Why a run has not finished, as far as its end state shows.
 *
 * @param kind what the robots can still do
 * @param cause the likely cause, in one line; empty if the run has finished
 * @param robots the unfinished robots
 * @param down robots that had crashed at the end
 */
public record Diagnosis(Kind kind, String cause, List<UnfinishedRobot> robots, Set<RobotId> down) {

  /** A run of which nothing is known, or that has finished. */
  public static final Diagnosis NONE = new Diagnosis(Kind.FINISHED, "", List.of(), Set.of());

  /** Without a change for this long, a run counts as stuck. */
  private static final long STUCK_NS = 10_000_000_000L;

  /** What the robots can still do. */
  public enum Kind {
    /** Every app has ended, or nothing is known. */
    FINISHED,
    /** No event is left: no robot can ever go on. */
    NO_EVENT_LEFT,
    /** Robots wait for each other in a circle. */
    CIRCLE,
    /** Events are left, but no variable of an unfinished robot has changed for 10 s. */
    STUCK,
    /** Variables still change: the run is slow, or repeats itself for ever. */
    ACTIVE
  }

  public Diagnosis {
    robots = List.copyOf(robots);
    down = Set.copyOf(down);
  }

  /**
   * @param isIdle whether no event is left
   */
  static Diagnosis of(List<UnfinishedRobot> robots, Set<RobotId> down, long endNs, boolean isIdle) {
    if (robots.isEmpty()) {
      return NONE;
    }
    List<RobotId> circle = circle(graph(robots));
    long changedNs = robots.stream().mapToLong(UnfinishedRobot::changedNs).max().orElse(-1);
    boolean isStuck = changedNs >= 0 && endNs - changedNs >= STUCK_NS;
    if (!circle.isEmpty()) {
      List<String> names = new ArrayList<>(circle.stream().map(RobotId::name).toList());
      names.add(names.get(0));
      String cause = "deadlock: robots wait in a circle: " + String.join(" -> ", names);
      return new Diagnosis(isIdle ? Kind.NO_EVENT_LEFT : Kind.CIRCLE, cause, robots, down);
    }
    String first = first(robots, down);
    if (isIdle) {
      String cause = "deadlock: no event is left, so no robot can go on; " + first;
      return new Diagnosis(Kind.NO_EVENT_LEFT, cause, robots, down);
    }
    if (isStuck) {
      String cause = "stuck: nothing has changed since " + seconds(changedNs) + "; " + first;
      return new Diagnosis(Kind.STUCK, cause, robots, down);
    }
    String when = changedNs < 0 ? "" : ": variables still changed at " + seconds(changedNs);
    String cause = "slow or a livelock" + when + "; " + first;
    return new Diagnosis(Kind.ACTIVE, cause, robots, down);
  }

  /** Which robot waits for which, without robots that wait for none. */
  public SortedMap<RobotId, Set<RobotId>> graph() {
    return graph(robots);
  }

  /** The whole diagnosis for people: the cause, the graph, each robot. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    if (!robots.isEmpty()) {
      lines.add("likely cause: " + cause);
      graph().forEach((robot, others) -> lines.add("  " + robot + " waits for " + others));
      robots.forEach(robot -> robot.lines().forEach(line -> lines.add("  " + line)));
    }
    return lines;
  }

  /** The state of the robot for which most others wait, directly or not. */
  private static String first(List<UnfinishedRobot> robots, Set<RobotId> down) {
    SortedMap<RobotId, Set<RobotId>> graph = graph(robots);
    Map<RobotId, Integer> waiters = new TreeMap<>();
    graph
        .keySet()
        .forEach(from -> reached(graph, from).forEach(to -> waiters.merge(to, 1, Integer::sum)));
    RobotId most =
        waiters.entrySet().stream()
            .max(Comparator.comparingInt(Map.Entry::getValue))
            .map(Map.Entry::getKey)
            .orElse(robots.get(0).robot());
    if (down.contains(most)) {
      return waiters.get(most) + " robots wait for " + most + ", which has crashed";
    }
    return robots.stream()
        .filter(robot -> robot.robot().equals(most))
        .findFirst()
        .map(UnfinishedRobot::brief)
        .orElse(waiters.get(most) + " robots wait for " + most + ", whose app has ended");
  }

  private static SortedMap<RobotId, Set<RobotId>> graph(List<UnfinishedRobot> robots) {
    SortedMap<RobotId, Set<RobotId>> graph = new TreeMap<>();
    for (UnfinishedRobot robot : robots) {
      if (!robot.waitsFor().isEmpty()) {
        graph.put(robot.robot(), robot.waitsFor());
      }
    }
    return graph;
  }

  /** The robots of one circle, in order; empty if there is none. */
  private static List<RobotId> circle(SortedMap<RobotId, Set<RobotId>> graph) {
    for (RobotId start : graph.keySet()) {
      List<RobotId> way = way(graph, start);
      if (!way.isEmpty()) {
        return way;
      }
    }
    return List.of();
  }

  /** A shortest way from {@code start} back to it; empty if there is none. */
  private static List<RobotId> way(SortedMap<RobotId, Set<RobotId>> graph, RobotId start) {
    List<List<RobotId>> ways = new ArrayList<>(List.of(List.of(start)));
    Set<RobotId> seen = new TreeSet<>();
    for (int i = 0; i < ways.size(); i++) {
      List<RobotId> way = ways.get(i);
      for (RobotId next : graph.getOrDefault(way.get(way.size() - 1), Set.of())) {
        if (next.equals(start)) {
          return way;
        }
        if (seen.add(next)) {
          List<RobotId> longer = new ArrayList<>(way);
          longer.add(next);
          ways.add(longer);
        }
      }
    }
    return List.of();
  }

  private static Set<RobotId> reached(SortedMap<RobotId, Set<RobotId>> graph, RobotId from) {
    Set<RobotId> reached = new LinkedHashSet<>(graph.getOrDefault(from, Set.of()));
    List<RobotId> open = new ArrayList<>(reached);
    for (int i = 0; i < open.size(); i++) {
      for (RobotId next : graph.getOrDefault(open.get(i), Set.of())) {
        if (reached.add(next)) {
          open.add(next);
        }
      }
    }
    return reached;
  }

  static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.3f s", ns / 1e9);
  }
}

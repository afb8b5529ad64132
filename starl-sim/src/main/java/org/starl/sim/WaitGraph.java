package org.starl.sim;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.RobotId;

/**
 * Which robot waits for which other robots; without robots that wait for none.
 *
 * @param waits a robot, and the robots that must act before it goes on
 */
public record WaitGraph(SortedMap<RobotId, Set<RobotId>> waits) {

  public WaitGraph {
    SortedMap<RobotId, Set<RobotId>> copy = new TreeMap<>();
    waits.forEach((robot, on) -> {
      Set<RobotId> others = new TreeSet<>(on);
      others.remove(robot);
      if (!others.isEmpty()) {
        copy.put(robot, Collections.unmodifiableSet(others));
      }
    });
    waits = Collections.unmodifiableSortedMap(copy);
  }

  /** The robots for which {@code robot} waits. */
  public Set<RobotId> of(RobotId robot) {
    return waits.getOrDefault(robot, Set.of());
  }

  /** The robots of a circle, each waiting for the next and the last for the first; empty if none. */
  public List<RobotId> circle() {
    SortedMap<RobotId, Set<RobotId>> inner = inner();
    for (RobotId start : inner.keySet()) {
      List<RobotId> way = way(inner, start);
      if (!way.isEmpty()) {
        return way;
      }
    }
    return List.of();
  }

  /** Whether waits lead from {@code from} to {@code to}; from a robot to itself in a circle. */
  public boolean leads(RobotId from, RobotId to) {
    Set<RobotId> reached = new TreeSet<>();
    Deque<RobotId> open = new ArrayDeque<>(List.of(from));
    while (!open.isEmpty() && !reached.contains(to)) {
      for (RobotId next : of(open.remove())) {
        if (reached.add(next)) {
          open.add(next);
        }
      }
    }
    return reached.contains(to);
  }

  /** How many robots wait for {@code robot} directly. */
  public long waiters(RobotId robot) {
    return waits.values().stream().filter(on -> on.contains(robot)).count();
  }

  /**
   * The robot at the end of a chain of waits that goes on, from each robot, to the one for which most
   * robots wait. There must be no circle.
   *
   * @param none the result if no robot waits for another
   */
  RobotId bottleneck(RobotId none) {
    Map<RobotId, Integer> waiters = new TreeMap<>();
    waits.values().forEach(on -> on.forEach(robot -> waiters.merge(robot, 1, Integer::sum)));
    Comparator<RobotId> byWaiters = Comparator.comparing(waiters::get);
    RobotId last = waiters.keySet().stream().max(byWaiters).orElse(none);
    while (waits.containsKey(last)) {
      last = of(last).stream().max(byWaiters).orElse(none);
    }
    return last;
  }

  // Without robots that lead to no circle, and robots to which none leads: few are left to search.
  private SortedMap<RobotId, Set<RobotId>> inner() {
    SortedMap<RobotId, Set<RobotId>> inner = new TreeMap<>(waits);
    boolean isSmaller = true;
    while (isSmaller) {
      isSmaller = inner.values().removeIf(on -> Collections.disjoint(on, inner.keySet()));
      Set<RobotId> awaited = new TreeSet<>();
      inner.values().forEach(awaited::addAll);
      isSmaller |= inner.keySet().retainAll(awaited);
    }
    return inner;
  }

  /** A shortest way from {@code start} back to it; empty if there is none. */
  private static List<RobotId> way(SortedMap<RobotId, Set<RobotId>> waits, RobotId start) {
    Map<RobotId, RobotId> cameFrom = new TreeMap<>();
    Deque<RobotId> open = new ArrayDeque<>(List.of(start));
    while (!open.isEmpty()) {
      RobotId from = open.remove();
      for (RobotId to : waits.getOrDefault(from, Set.of())) {
        if (cameFrom.putIfAbsent(to, from) == null) {
          open.add(to);
        }
      }
      if (cameFrom.containsKey(start)) {
        return way(cameFrom, start);
      }
    }
    return List.of();
  }

  private static List<RobotId> way(Map<RobotId, RobotId> cameFrom, RobotId start) {
    List<RobotId> way = new ArrayList<>(List.of(start));
    RobotId robot = cameFrom.get(start);
    while (robot != null && !robot.equals(start)) {
      way.add(1, robot);
      robot = cameFrom.get(robot);
    }
    return way;
  }
}

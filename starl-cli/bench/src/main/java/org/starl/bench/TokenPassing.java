package org.starl.bench;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;

/**
 * A central planner of deliveries: token passing (Ma, Li, Kumar, Koenig, "Lifelong Multi-Agent Path
 * Finding for Online Pickup and Delivery Tasks", AAMAS 2017). It knows where all robots are, at once and
 * without error.
 *
 * <p>Lanes are cut into <em>cells</em> of nearly equal length, and time into steps in which a robot drives
 * one cell at constant speed: turns, braking and charging take no time. A robot without work takes the
 * token at once, chooses the delivery whose load is nearest, among those at whose ends no other path
 * ends, and plans by A* over cells and steps, around all paths in the token. It finds none: it plans a
 * way home, or stays. At most one robot is in a cell or in a group of lanes in a step, and no two exchange
 * their cells. Equal inputs give equal plans.
 */
final class TokenPassing {

  /** Searches that visit more states count as failed. */
  private static final int MOST_STATES = 100_000;

  /** Deliveries that a robot tries to plan before it gives up until the next step. */
  private static final int MOST_TRIES = 4;

  /** The run ends if no delivery ends for so many steps. */
  private static final int MOST_IDLE = 20_000;

  private static final int EVER = Integer.MAX_VALUE;

  /**
   * A plan that was carried out.
   *
   * @param delivered deliveries that were put down
   * @param lastMs when the last one was
   * @param cells of each robot the cell in each step; places have the lowest numbers
   * @param groups of each group of lanes its cells
   */
  record Plan(int delivered, long lastMs, List<List<Integer>> cells, List<List<Integer>> groups) {

    /** Until the last one was put down; 0 if there was none. */
    double anHour() {
      return delivered == 0 ? 0 : delivered * 3_600_000.0 / lastMs;
    }
  }

  private record State(int cell, int step, int left, @Nullable State before) {}

  private final List<List<Integer>> next = new ArrayList<>();
  private final List<List<Integer>> previous = new ArrayList<>();

  /** Of each cell the numbers of its groups. */
  private final List<List<Integer>> groups = new ArrayList<>();

  private final double stepMs;
  private final int handleSteps;

  // The token: cells and groups in steps, moves, and the cells where paths end.
  private final List<BitSet> taken = new ArrayList<>();
  private final List<BitSet> takenGroups = new ArrayList<>();
  private final Set<List<Integer>> moves = new HashSet<>();
  private final int[] ends;
  private final List<List<Integer>> paths = new ArrayList<>();

  private final List<Integer> homes;
  private final Map<Integer, int[]> steps = new LinkedHashMap<>();

  /**
   * @param homes of each robot the vertex where it begins; no other robot drives through it
   * @param leastMm from one cell to the next, at least: robots must not touch there
   * @param handleMs to pick up and to put down
   */
  TokenPassing(
      NavGraph graph, List<Integer> homes, double leastMm, double speedMmPerS, long handleMs) {
    double cellMm = cellMm(graph, leastMm);
    stepMs = 1000 * cellMm / speedMmPerS;
    handleSteps = (int) StrictMath.ceil(handleMs / stepMs);
    this.homes = List.copyOf(homes);
    graph.vertices().forEach(vertex -> addCell(List.of()));
    List<String> names = new ArrayList<>();
    Map<List<Integer>, List<Integer>> chains = new LinkedHashMap<>();
    for (Lane lane : graph.lanes()) {
      for (String name : graph.groups(lane)) {
        if (!names.contains(name)) {
          names.add(name);
          takenGroups.add(new BitSet());
        }
      }
      List<Integer> its = graph.groups(lane).stream().map(names::indexOf).toList();
      // Both directions of a lane have the same cells.
      List<Integer> chain = chains.get(List.of(lane.to(), lane.from()));
      chain = chain == null ? chain(lane, cells(graph, lane, cellMm), its) : chain.reversed();
      chains.put(List.of(lane.from(), lane.to()), chain);
      for (int i = 0; i + 1 < chain.size(); i++) {
        next.get(chain.get(i)).add(chain.get(i + 1));
        previous.get(chain.get(i + 1)).add(chain.get(i));
      }
    }
    ends = homes.stream().mapToInt(home -> home).toArray();
    homes.forEach(home -> paths.add(new ArrayList<>(List.of(home))));
  }

  /** The length with which the cells of all lanes together differ least from the lanes. */
  private static double cellMm(NavGraph graph, double leastMm) {
    double best = leastMm;
    double leastWrong = Double.POSITIVE_INFINITY;
    for (double mm = leastMm; mm <= 2 * leastMm; mm += leastMm / 100) {
      double wrong = 0;
      for (Lane lane : graph.lanes()) {
        wrong += Math.abs(cells(graph, lane, mm) * mm - graph.lengthMm(lane));
      }
      if (wrong < leastWrong) {
        leastWrong = wrong;
        best = mm;
      }
    }
    return best;
  }

  /** A lane of a group has one cell of its own at least. */
  private static int cells(NavGraph graph, Lane lane, double mm) {
    int least = graph.groups(lane).isEmpty() ? 1 : 2;
    return (int) Math.max(least, Math.round(graph.lengthMm(lane) / mm));
  }

  private List<Integer> chain(Lane lane, int count, List<Integer> its) {
    List<Integer> chain = new ArrayList<>(List.of(lane.from()));
    for (int i = 1; i < count; i++) {
      chain.add(addCell(its));
    }
    chain.add(lane.to());
    return chain;
  }

  private int addCell(List<Integer> its) {
    next.add(new ArrayList<>());
    previous.add(new ArrayList<>());
    groups.add(its);
    taken.add(new BitSet());
    return groups.size() - 1;
  }

  /** The plan for these deliveries. Call it once. */
  Plan plan(List<Delivery> deliveries) {
    List<Delivery> open = new ArrayList<>();
    int known = 0;
    int delivered = 0;
    int last = 0;
    for (int step = 0; delivered < deliveries.size() && step < last + MOST_IDLE; step++) {
      while (known < deliveries.size() && deliveries.get(known).atMs() <= step * stepMs) {
        open.add(deliveries.get(known++));
      }
      last = open.isEmpty() ? step : last;
      for (int robot = 0; robot < homes.size(); robot++) {
        if (paths.get(robot).size() - 1 <= step) {
          stay(robot, step);
          if (take(robot, open)) {
            delivered++;
            last = Math.max(last, paths.get(robot).size() - 1);
          }
        }
      }
    }
    return new Plan(delivered, (long) (last * stepMs), paths, cellsOfGroups());
  }

  private List<List<Integer>> cellsOfGroups() {
    List<List<Integer>> cells = new ArrayList<>();
    takenGroups.forEach(group -> cells.add(new ArrayList<>()));
    for (int cell = 0; cell < groups.size(); cell++) {
      for (int group : groups.get(cell)) {
        cells.get(group).add(cell);
      }
    }
    return cells;
  }

  private void stay(int robot, int until) {
    List<Integer> path = paths.get(robot);
    while (path.size() <= until) {
      add(robot, List.of(path.get(path.size() - 1)));
    }
  }

  /** Whether the robot has taken one of the open deliveries. */
  private boolean take(int robot, List<Delivery> open) {
    List<Delivery> nearest =
        open.stream()
            .filter(one -> isFree(one.pick(), robot) && isFree(one.drop(), robot))
            .sorted(Comparator.comparingInt(one -> steps(one.pick())[ends[robot]]))
            .limit(MOST_TRIES)
            .toList();
    for (Delivery delivery : nearest) {
      List<Integer> way = way(robot, delivery);
      if (way != null) {
        add(robot, way);
        open.remove(delivery);
        return true;
      }
    }
    if (ends[robot] != homes.get(robot)) {
      List<Integer> home = way(robot, ends[robot], now(robot), homes.get(robot), EVER);
      add(robot, home == null ? List.of() : home);
    }
    return false;
  }

  private int now(int robot) {
    return paths.get(robot).size() - 1;
  }

  private boolean isFree(int cell, int robot) {
    for (int other = 0; other < ends.length; other++) {
      if (other != robot && ends[other] == cell) {
        return false;
      }
    }
    return true;
  }

  private @Nullable List<Integer> way(int robot, Delivery delivery) {
    List<Integer> there = way(robot, ends[robot], now(robot), delivery.pick(), handleSteps);
    if (there == null) {
      return null;
    }
    List<Integer> all = new ArrayList<>(there);
    addTimes(all, delivery.pick());
    List<Integer> on = way(robot, delivery.pick(), now(robot) + all.size(), delivery.drop(), EVER);
    if (on == null) {
      return null;
    }
    all.addAll(on);
    addTimes(all, delivery.drop());
    return all;
  }

  private void addTimes(List<Integer> way, int cell) {
    for (int i = 0; i < handleSteps; i++) {
      way.add(cell);
    }
  }

  /**
   * The cells after the first one to {@code goal}, as early as possible, where the robot can stay for
   * some steps; null if none is found.
   */
  private @Nullable List<Integer> way(int robot, int from, int step, int goal, int stay) {
    int[] left = steps(goal);
    PriorityQueue<State> queue =
        new PriorityQueue<>(
            Comparator.comparingInt((State state) -> state.step() + state.left())
                .thenComparingInt(State::left)
                .thenComparingInt(State::cell));
    queue.add(new State(from, step, left[from], null));
    Set<List<Integer>> seen = new HashSet<>();
    while (!queue.isEmpty() && seen.size() < MOST_STATES) {
      State state = queue.remove();
      if (state.cell() == goal && canStay(robot, goal, state.step(), stay)) {
        return cells(state);
      }
      List<Integer> after = new ArrayList<>(next.get(state.cell()));
      after.add(state.cell());
      for (int cell : after) {
        int at = state.step() + 1;
        if (left[cell] < EVER
            && isOpen(robot, state.cell(), cell, at)
            && seen.add(List.of(cell, at))) {
          queue.add(new State(cell, at, left[cell], state));
        }
      }
    }
    return null;
  }

  private static List<Integer> cells(State last) {
    List<Integer> cells = new ArrayList<>();
    for (State state = last; state.before() != null; state = state.before()) {
      cells.add(state.cell());
    }
    return cells.reversed();
  }

  private boolean canStay(int robot, int cell, int step, int stay) {
    int taking = taken.get(cell).nextSetBit(step + 1);
    return isFree(cell, robot) && (taking < 0 || (stay < EVER && taking > step + stay));
  }

  private boolean isOpen(int robot, int from, int to, int step) {
    boolean isHome = homes.contains(to) && homes.get(robot) != to;
    boolean isTaken =
        taken.get(to).get(step)
            || groups.get(to).stream().anyMatch(group -> takenGroups.get(group).get(step));
    return !isHome
        && !isTaken
        && !isHeld(robot, to, step)
        && !moves.contains(List.of(to, from, step));
  }

  /** Whether another robot stays there after the end of its path. */
  private boolean isHeld(int robot, int cell, int step) {
    for (int other = 0; other < ends.length; other++) {
      if (other != robot && ends[other] == cell && step >= now(other)) {
        return true;
      }
    }
    return false;
  }

  private void add(int robot, List<Integer> way) {
    List<Integer> path = paths.get(robot);
    for (int cell : way) {
      int step = path.size();
      moves.add(List.of(path.get(step - 1), cell, step));
      taken.get(cell).set(step);
      groups.get(cell).forEach(group -> takenGroups.get(group).set(step));
      path.add(cell);
      ends[robot] = cell;
    }
  }

  /** Of each cell the steps to {@code goal} on an empty floor; {@link #EVER} if there is no way. */
  private int[] steps(int goal) {
    int[] known = steps.get(goal);
    if (known != null) {
      return known;
    }
    int[] left = new int[groups.size()];
    Arrays.fill(left, EVER);
    left[goal] = 0;
    ArrayDeque<Integer> queue = new ArrayDeque<>(List.of(goal));
    while (!queue.isEmpty()) {
      int cell = queue.remove();
      for (int before : previous.get(cell)) {
        if (left[before] == EVER) {
          left[before] = left[cell] + 1;
          queue.add(before);
        }
      }
    }
    steps.put(goal, left);
    return left;
  }
}

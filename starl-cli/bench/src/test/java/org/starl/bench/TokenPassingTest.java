package org.starl.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;

class TokenPassingTest {

  private static final int SIDE = 4;
  private static final long HANDLE_MS = 2000;

  /** Crossings, a metre apart, with a home at each crossing of the left side; lanes lead both ways. */
  private static NavGraph grid(String group) {
    List<Vertex> vertices = new ArrayList<>();
    List<Lane> lanes = new ArrayList<>();
    for (int i = 0; i < SIDE * SIDE; i++) {
      int x = i % SIDE;
      int y = i / SIDE;
      boolean isStation = x == SIDE - 1;
      vertices.add(new Vertex("v" + i, new Point(1000 * x, 1000 * y), false, isStation, false));
      if (x > 0) {
        join(lanes, i - 1, i, x == 2 ? group : "");
      }
      if (y > 0) {
        join(lanes, i - SIDE, i, "");
      }
    }
    for (int y = 0; y < SIDE; y++) {
      vertices.add(new Vertex("home" + y, new Point(-1000, 1000 * y), false, false, true));
      join(lanes, SIDE * SIDE + y, SIDE * y, "");
    }
    return new NavGraph(vertices, lanes);
  }

  private static void join(List<Lane> lanes, int one, int other, String group) {
    lanes.add(new Lane(one, other, group));
    lanes.add(new Lane(other, one, group));
  }

  private static TokenPassing planner(NavGraph graph, int robots) {
    List<Integer> homes = new ArrayList<>();
    for (int robot = 0; robot < robots; robot++) {
      homes.add(SIDE * SIDE + robot);
    }
    return new TokenPassing(graph, homes, 500, 500, HANDLE_MS);
  }

  private static List<Delivery> drawn(long seed, int count) {
    Random random = new Random(seed);
    List<Delivery> deliveries = new ArrayList<>();
    long ms = 0;
    for (int i = 0; i < count; i++) {
      ms += random.nextInt(20_000);
      int pick = random.nextInt(SIDE);
      int drop = (pick + 1 + random.nextInt(SIDE - 1)) % SIDE;
      deliveries.add(new Delivery(ms, SIDE * pick + SIDE - 1, SIDE * drop + SIDE - 1));
    }
    return deliveries;
  }

  /** Home, 4 m to the load, 1 m to its station, and twice 2 s, at 0.5 m/s. */
  @Example
  void oneRobotAloneDrivesTheShortestWay() {
    TokenPassing.Plan plan =
        planner(grid(""), 1).plan(List.of(new Delivery(0, SIDE - 1, 2 * SIDE - 1)));
    assertThat(plan.delivered()).isEqualTo(1);
    assertThat(plan.lastMs()).isEqualTo(8000 + 2000 + 2000 + 2000);
    assertThat(plan.anHour()).isEqualTo(3_600_000.0 / 14_000);
  }

  @Property(tries = 40)
  void robotsDeliverAllAndNeverMeet(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 4) int robots) {
    NavGraph graph = grid("");
    List<Delivery> deliveries = drawn(seed, 12);
    TokenPassing.Plan plan = planner(graph, robots).plan(deliveries);
    assertThat(plan.delivered()).isEqualTo(deliveries.size());
    for (int a = 0; a < robots; a++) {
      for (int b = 0; b < a; b++) {
        for (int step = 1; step <= longest(plan); step++) {
          int isA = cell(plan, a, step);
          int isB = cell(plan, b, step);
          assertThat(isA).isNotEqualTo(isB);
          boolean isExchange = isA == cell(plan, b, step - 1) && isB == cell(plan, a, step - 1);
          assertThat(isExchange).isFalse();
        }
      }
    }
    assertThat(planner(graph, robots).plan(deliveries)).isEqualTo(plan);
  }

  /** All lanes to the right half are one group. */
  @Property(tries = 20)
  void oneRobotAtATimeIsInAGroup(@ForAll long seed) {
    TokenPassing.Plan plan = planner(grid("gate"), 4).plan(drawn(seed, 12));
    assertThat(plan.delivered()).isEqualTo(12);
    // Of the gate's lanes, each has one cell of its own.
    List<Integer> gate = plan.groups().get(0);
    for (int step = 0; step <= longest(plan); step++) {
      int inGate = 0;
      for (int robot = 0; robot < 4; robot++) {
        inGate += gate.contains(cell(plan, robot, step)) ? 1 : 0;
      }
      assertThat(inGate).isLessThanOrEqualTo(1);
    }
  }

  private static int longest(TokenPassing.Plan plan) {
    return plan.cells().stream().mapToInt(List::size).max().orElseThrow();
  }

  /** A robot stays where its path ends. */
  private static int cell(TokenPassing.Plan plan, int robot, int step) {
    List<Integer> path = plan.cells().get(robot);
    return path.get(Math.min(step, path.size() - 1));
  }
}

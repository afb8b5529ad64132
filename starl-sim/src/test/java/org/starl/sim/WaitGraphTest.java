package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;

/** A graph of waits finds a circle if there is one, and else the robot at the end of the waits. */
class WaitGraphTest {

  private static final int ROBOTS = 8;

  private static RobotId robot(int number) {
    return new RobotId("bot" + number);
  }

  /** Each number is an edge: from, and to. */
  private static WaitGraph graph(List<Integer> edges) {
    SortedMap<RobotId, Set<RobotId>> waits = new TreeMap<>();
    for (int edge : edges) {
      waits.computeIfAbsent(robot(edge / ROBOTS), any -> new TreeSet<>()).add(robot(edge % ROBOTS));
    }
    return new WaitGraph(waits);
  }

  private static Set<RobotId> reached(WaitGraph graph, RobotId from) {
    Set<RobotId> reached = new TreeSet<>(graph.of(from));
    boolean isLarger = true;
    while (isLarger) {
      Set<RobotId> next = new TreeSet<>();
      reached.forEach(robot -> next.addAll(graph.of(robot)));
      isLarger = reached.addAll(next);
    }
    return reached;
  }

  @Property
  void aCircleIsFoundIfThereIsOne(
      @ForAll @Size(max = 20) List<@IntRange(max = ROBOTS * ROBOTS - 1) Integer> edges) {
    WaitGraph graph = graph(edges);
    List<RobotId> circle = graph.circle();
    for (int i = 0; i < circle.size(); i++) {
      assertThat(graph.of(circle.get(i))).contains(circle.get((i + 1) % circle.size()));
    }
    assertThat(circle).doesNotHaveDuplicates();
    boolean isCircular = false;
    for (int i = 0; i < ROBOTS; i++) {
      boolean isInCircle = reached(graph, robot(i)).contains(robot(i));
      assertThat(graph.leads(robot(i), robot(i))).isEqualTo(isInCircle);
      isCircular |= isInCircle;
    }
    assertThat(circle.isEmpty()).isEqualTo(!isCircular);
  }

  @Property
  void withoutACircleTheBottleneckWaitsForNone(
      @ForAll @Size(max = 20) List<@IntRange(max = ROBOTS * ROBOTS - 1) Integer> edges) {
    // Each robot waits for higher numbers only.
    WaitGraph graph = graph(edges.stream().filter(edge -> edge / ROBOTS < edge % ROBOTS).toList());
    RobotId bottleneck = graph.bottleneck(robot(99));
    assertThat(graph.of(bottleneck)).isEmpty();
    assertThat(graph.waiters(bottleneck) > 0).isEqualTo(!graph.waits().isEmpty());
  }

  @Test
  void theBottleneckIsTheEndOfTheLongestQueue() {
    // 0 and 1 wait for 2, which waits for 3; 4 waits for 5.
    WaitGraph graph = graph(List.of(2, ROBOTS + 2, 2 * ROBOTS + 3, 4 * ROBOTS + 5));
    assertThat(graph.bottleneck(robot(99))).isEqualTo(robot(3));
  }
}

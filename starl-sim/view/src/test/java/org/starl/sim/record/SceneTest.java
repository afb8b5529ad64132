package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class SceneTest {

  private static final Var<Integer> X = Var.of("x", Shapes.INT);

  private final Scene scene = new Scene(Obstacles.NONE);

  private static RobotId bot(int number) {
    return new RobotId("bot" + number);
  }

  private void joins(long atNs, int number) {
    scene.observe(
        new TraceEvent.Joined(atNs, bot(number), Pose.of(new Point(number * 500.0, 0), 0), 165));
  }

  @Test
  void onlyTheLastTwelveRobotsThatLeftAreKept() {
    joins(0, 100);
    for (int i = 0; i < 50; i++) {
      joins(2 * i, i);
      scene.observe(new TraceEvent.Variable(2 * i, bot(i), Instance.APP, X, i));
      scene.observe(new TraceEvent.Left(2 * i + 1, bot(i)));
    }
    assertThat(scene.robots()).hasSize(13).contains(bot(100), bot(49), bot(38));
    assertThat(scene.variable(bot(37), X)).isNull();
    assertThat(scene.variables(bot(37))).isEmpty();
    assertThat(scene.trail(bot(37))).isEmpty();
    assertThat(scene.variable(bot(38), X)).isEqualTo(38);
    assertThat(scene.text(bot(38), Instance.APP, "x")).isEqualTo("38");
    assertThat(scene.pose(bot(49))).isEmpty();
    assertThat(scene.pose(bot(100))).isPresent();
  }

  @Test
  void aRobotKeepsItsNumberWhileOthersJoinAndLeave() {
    joins(0, 7);
    joins(1, 3);
    int number = scene.number(bot(3));
    assertThat(number).isNotEqualTo(scene.number(bot(7)));
    for (int i = 10; i < 40; i++) {
      joins(i, i);
      scene.observe(new TraceEvent.Left(i, bot(i)));
    }
    assertThat(scene.number(bot(3))).isEqualTo(number);
  }

  @Test
  void aRobotThatJoinsAgainIsKept() {
    joins(0, 1);
    scene.observe(new TraceEvent.Left(1, bot(1)));
    joins(2, 1);
    for (int i = 10; i < 40; i++) {
      joins(i, i);
      scene.observe(new TraceEvent.Left(i, bot(i)));
    }
    assertThat(scene.pose(bot(1))).isPresent();
    assertThat(scene.trail(bot(1))).hasSize(2);
  }

  @Test
  void aLongTrailHasItsFirstPointItsLatestOnesAndFewInBetween() {
    joins(0, 0);
    int seconds = 10_000;
    scene.observe(new TraceEvent.Moved(0, bot(0), new Pose(0, 0, 0), 10, 0));
    Scene early = scene.copy();
    scene.advance(seconds * 1_000_000_000L);
    early.advance(1_000_000_000L);
    assertThat(early.trail(bot(0))).hasSize(11);
    List<Point> trail = scene.trail(bot(0));
    int size = trail.size();
    assertThat(size).isBetween(8192, 16_384);
    assertThat(scene.driven(bot(0))).isEqualTo(10 * seconds + 1);
    assertThat(trail.get(0)).isEqualTo(new Point(0, 0));
    for (int i = 1; i <= 8000; i++) {
      assertThat(trail.get(size - i).xMm()).isCloseTo(10.0 * seconds + 1 - i, within(1e-6));
    }
    for (int i = 1; i < size; i++) {
      assertThat(trail.get(i).xMm()).isGreaterThan(trail.get(i - 1).xMm() - 1e-9);
    }
  }

  @Test
  void theTrailsOfAllRobotsHaveABudget() {
    int robots = 200;
    for (int i = 0; i < robots; i++) {
      joins(0, i);
      scene.observe(new TraceEvent.Moved(0, bot(i), new Pose(0, 0, 0), 10, 0));
    }
    scene.advance(1000 * 1_000_000_000L);
    int points = scene.robots().stream().mapToInt(robot -> scene.trail(robot).size()).sum();
    assertThat(points).isBetween(1 << 18, 1 << 19);
  }

  @Test
  void manyRobotsHaveShortTrails() {
    for (int i = 0; i < 1000; i++) {
      joins(0, i);
      scene.observe(new TraceEvent.Moved(0, bot(i), new Pose(0, 0, 0), 10, 0));
    }
    scene.advance(100 * 1_000_000_000L);
    assertThat(scene.trail(bot(0))).hasSizeBetween(40, 80);
    assertThat(scene.trail(bot(0)).getLast().xMm()).isCloseTo(1000, within(1e-6));
  }
}

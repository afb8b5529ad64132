package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

class SceneTest {

  private final Scene scene = new Scene(Obstacles.NONE);

  private static RobotId bot(int number) {
    return new RobotId("bot" + number);
  }

  private void joins(long atNs, int number) {
    scene.observe(
        new TraceEvent.Joined(atNs, bot(number), Pose.of(new Point(number * 500.0, 0), 0), 165));
  }

  @Test
  void onlyTheLastRemovedRobotsAreKept() {
    joins(0, 100);
    for (int i = 0; i < 50; i++) {
      joins(2 * i, i);
      scene.observe(new TraceEvent.Variable(2 * i, bot(i), "app", "x", "" + i));
      scene.observe(new TraceEvent.Left(2 * i + 1, bot(i)));
    }
    assertThat(scene.robots()).hasSize(13).contains(bot(100), bot(49), bot(38));
    assertThat(scene.variable(bot(37), "app", "x")).isEmpty();
    assertThat(scene.trail(bot(37))).isEmpty();
    assertThat(scene.variable(bot(38), "app", "x")).isEqualTo("38");
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
  void aReturningRobotIsKept() {
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
}

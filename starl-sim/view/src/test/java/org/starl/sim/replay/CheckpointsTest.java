package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;
import org.starl.trace.TraceEvent;

class CheckpointsTest {

  private static final long NS_PER_S = 1_000_000_000;

  private static Scene moving(int robots) {
    Scene scene = new Scene(Obstacles.NONE);
    for (int i = 0; i < robots; i++) {
      RobotId robot = new RobotId("bot" + i);
      scene.observe(new TraceEvent.Joined(0, robot, new Pose(0, i, 0), 165));
      scene.observe(new TraceEvent.Moved(0, robot, new Pose(0, i, 0), 10, 0));
    }
    return scene;
  }

  private static long points(Scene scene) {
    return scene.robots().stream().mapToLong(robot -> scene.trail(robot).size()).sum();
  }

  @Test
  void thePointsOfAllTrailsFitTheMemory() {
    int robots = 50;
    long mostBytes = 40_000_000;
    Scene scene = moving(robots);
    Checkpoints checkpoints = new Checkpoints(scene.copy(), Layer.NONE, mostBytes);
    int events = 0;
    for (int s = 0; s < 3600; s += 10) {
      scene.advance(s * NS_PER_S);
      events += 1 << 10;
      checkpoints.add(events, scene, Layer.NONE);
    }
    assertThat(checkpoints.size()).isGreaterThan(1);
    assertThat(16 * points(scene) * (checkpoints.size() - 1)).isLessThan(mostBytes);
  }

  @Test
  void withLittleMemoryThereAreTwoCheckpoints() {
    Scene scene = moving(50);
    Checkpoints checkpoints = new Checkpoints(scene.copy(), Layer.NONE, 1);
    for (int i = 1; i <= 1 << 10; i++) {
      checkpoints.add(i << 9, scene, Layer.NONE);
      assertThat(checkpoints.size()).isLessThanOrEqualTo(2);
    }
    assertThat(checkpoints.before(1 << 19).events()).isGreaterThanOrEqualTo(1 << 18);
  }
}

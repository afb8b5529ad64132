package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;

class BodiesTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final long SECOND = 1_000_000_000;

  private final Bodies bodies = new Bodies();

  @Test
  void aBodyStaysWhereItJoinedUntilItMoves() {
    bodies.observe(new Joined(0, BOT, new Pose(10, 20, 1), 165));
    assertThat(bodies.poseAt(BOT, 5 * SECOND)).isEqualTo(new Pose(10, 20, 1));
    assertThat(bodies.isMoving(BOT)).isFalse();
    assertThat(bodies.radiusMm(BOT)).isEqualTo(165);
  }

  @Test
  void aBodyMovesAlongItsArcBetweenTwoEvents() {
    bodies.observe(new Joined(0, BOT, new Pose(0, 0, 0), 165));
    bodies.observe(new Moved(SECOND, BOT, new Pose(0, 0, 0), 100, Math.PI / 2));
    Pose quarter = bodies.poseAt(BOT, 2 * SECOND);
    double radius = 100 / (Math.PI / 2);
    assertThat(quarter.xMm()).isCloseTo(radius, within(1e-9));
    assertThat(quarter.yMm()).isCloseTo(radius, within(1e-9));
    assertThat(bodies.isMoving(BOT)).isTrue();
  }

  @Test
  void aBodyThatLeftHasNoPose() {
    bodies.observe(new Joined(0, BOT, new Pose(0, 0, 0), 165));
    bodies.observe(new Left(1, BOT));
    assertThat(bodies.robots()).isEmpty();
    assertThatThrownBy(() -> bodies.poseAt(BOT, 2)).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void bodiesAreMovingUntilTheLastOneStopsOrLeaves() {
    RobotId other = new RobotId("bot1");
    bodies.observe(new Joined(0, BOT, new Pose(0, 0, 0), 165));
    bodies.observe(new Joined(0, other, new Pose(500, 0, 0), 165));
    assertThat(bodies.isAnyMoving()).isFalse();
    bodies.observe(new Moved(1, BOT, new Pose(0, 0, 0), 100, 0));
    bodies.observe(new Moved(1, other, new Pose(500, 0, 0), 0, 1));
    bodies.observe(new Moved(2, other, new Pose(500, 0, 0), -100, 0));
    bodies.observe(new Moved(3, BOT, new Pose(0, 0, 0), 50, 0));
    bodies.observe(new Moved(4, BOT, new Pose(0, 0, 0), 0, 1));
    assertThat(bodies.isAnyMoving()).isTrue();
    assertThat(bodies.copy().isAnyMoving()).isTrue();
    bodies.observe(new Left(5, other));
    assertThat(bodies.isAnyMoving()).isFalse();
  }
}

package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;

class KnownObstaclesTest {

  @Test
  void aContactIsAddedOnceWhereTheBodyTouches() {
    KnownObstacles known = new KnownObstacles(Obstacles.of(Obstacle.wall(p(0, 0), p(9, 0))));
    Pose pose = new Pose(100, 100, StrictMath.PI / 2);
    Point ahead = KnownObstacles.contact(pose, Bumps.BOTH, 165);
    Point right = KnownObstacles.contact(pose, Bumps.RIGHT, 165);
    assertThat(ahead.distanceMm(p(100, 265))).isLessThan(1e-9);
    assertThat(right.xMm()).isGreaterThan(200);
    Point left = KnownObstacles.contact(pose, Bumps.LEFT, 165);
    assertThat(left.distanceMm(p(200 - right.xMm(), right.yMm()))).isLessThan(1e-9);
    known.addContact(ahead, 10);
    known.addContact(ahead, 10);
    assertThat(known.all().all()).hasSize(2);
    assertThat(known.contacts()).isEqualTo(1);
    assertThat(known.all().distanceMm(ahead)).isZero();
  }

  private static Point p(double x, double y) {
    return new Point(x, y);
  }
}

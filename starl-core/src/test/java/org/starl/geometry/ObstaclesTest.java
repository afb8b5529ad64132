package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class ObstaclesTest {

  private static final Point A = new Point(0, 0);
  private static final Point B = new Point(100, 0);
  private static final Point C = new Point(100, 100);

  @Test
  void aBodyIsSolidAndAWallIsNot() {
    Point inside = new Point(90, 40);
    assertThat(Obstacle.body(A, B, C).distanceMm(inside)).isZero();
    assertThat(Obstacle.wall(A, B, C).distanceMm(inside)).isEqualTo(10);
  }

  @Test
  void aWallIsNotClosed() {
    Point nearTheGap = new Point(50, 50);
    assertThat(Obstacle.wall(A, B, C).distanceMm(nearTheGap)).isEqualTo(50);
    assertThat(Obstacle.wall(A, B, C).sides()).hasSize(2);
    assertThat(Obstacle.body(A, B, C).sides()).hasSize(3);
  }

  @Test
  void hiddenObstaclesAreNotKnown() {
    Obstacle wall = Obstacle.wall(A, B);
    Obstacle hidden = new Obstacle(List.of(B, C), false, true, Obstacle.FOREVER);
    assertThat(Obstacles.of(wall, hidden).known()).isEqualTo(Obstacles.of(wall));
  }

  @Test
  void anObstacleStandsForItsLifetime() {
    Obstacle brief = new Obstacle(List.of(A, B), false, false, 20);
    Obstacles both = Obstacles.of(brief, Obstacle.wall(B, C));
    assertThat(both.standingAt(19_999_999)).isSameAs(both);
    assertThat(both.standingAt(20_000_000).all()).containsExactly(Obstacle.wall(B, C));
  }

  @Test
  void theNearestObstacleCounts() {
    Obstacles two = Obstacles.NONE.plus(Obstacle.wall(A, B)).plus(Obstacle.wall(B, C));
    assertThat(two.distanceMm(new Point(103, 50))).isEqualTo(3);
    assertThat(Obstacles.NONE.distanceMm(A)).isInfinite();
  }

  @Test
  void invalidObstaclesAreRefused() {
    assertThatThrownBy(() -> Obstacle.wall(A)).hasMessageContaining("at least 2");
    assertThatThrownBy(() -> Obstacle.body(A, B)).hasMessageContaining("at least 3");
    assertThatThrownBy(() -> new Obstacle(List.of(A, B), false, false, -2))
        .hasMessageContaining("-1 for ever");
  }

  @Test
  void aLineIsNearTheSidesOfAnObstacleAndInsideASolidOne() {
    Point[] corners = {
      new Point(0, 0), new Point(1000, 0), new Point(1000, 1000), new Point(0, 1000)
    };
    Obstacles body = Obstacles.of(Obstacle.body(corners));
    Obstacles wall = Obstacles.of(Obstacle.wall(corners));
    Segment inside = new Segment(new Point(400, 500), new Point(600, 500));
    Segment beside = new Segment(new Point(1100, -50), new Point(1100, 2000));
    assertThat(body.isWithin(inside, 10)).isTrue();
    assertThat(wall.isWithin(inside, 10)).isFalse();
    assertThat(body.isWithin(beside, 100)).isFalse();
    assertThat(body.isWithin(beside, 101)).isTrue();
    assertThat(wall.isWithin(beside, 101)).isTrue();
  }
}

package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.random.Rng;

class TubeTest {

  private static final int SIDE_MM = 3_000;

  private final Rng rng = new Rng(1).fork("tubes");

  @Test
  void twoTubesMeetExactlyIfTwoOfTheirPartsDo() {
    int meetings = 0;
    for (int i = 0; i < 5_000; i++) {
      Tube one = tube();
      Tube other = tube();
      boolean meet =
          one.capsules().stream()
              .anyMatch(a -> other.capsules().stream().anyMatch(b -> a.distanceMm(b) < 1));
      assertThat(one.meets(other)).as("%s and %s", one, other).isEqualTo(meet);
      assertThat(other.meets(one)).as("%s and %s", other, one).isEqualTo(meet);
      meetings += meet ? 1 : 0;
    }
    assertThat(meetings).isBetween(500, 4_500);
  }

  @Test
  void discsThatAreOneMillimetreApartDoNotMeet() {
    Tube disc = Tube.disc(new Point(0, 0), 300);
    for (Point apart : List.of(new Point(601, 0), new Point(0, -601), new Point(-601, 0))) {
      assertThat(disc.meets(Tube.disc(apart, 300))).as("%s", apart).isFalse();
    }
    assertThat(disc.meets(Tube.disc(new Point(0, 600), 300))).isTrue();
  }

  private Tube tube() {
    List<Point> points = new ArrayList<>();
    int x = rng.nextInt(SIDE_MM);
    int y = rng.nextInt(SIDE_MM);
    for (int left = 1 + rng.nextInt(4); left > 0; left--) {
      points.add(new Point(x, y));
      x += rng.nextInt(1_000) - 500;
      y += rng.nextInt(1_000) - 500;
    }
    return new Tube(points, 200 + rng.nextInt(200));
  }
}

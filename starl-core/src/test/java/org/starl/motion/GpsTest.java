package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Circle;
import org.starl.geometry.Fix;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.testing.FakePlatform;
import org.starl.testing.FakeWorld;

/** What a robot may conclude from its fixes: each bound on its own side. */
class GpsTest {

  private static final Point P = new Point(1_000, 0);
  private static final Circle ZONE = new Circle(P, 100);

  private final FakeWorld world = new FakeWorld("bot0");
  private final FakePlatform robot = world.boot("bot0");
  private final Gps gps = new GlobalVarHolder(robot.platform(), 1).gps;

  private void fix(double xMm, long timeNs) {
    robot.fix(new Fix(new Pose(xMm, 0, 0), timeNs, 4, 0));
    world.runMs(0);
  }

  @Test
  void withoutAFixNothingIsCertain() {
    assertThat(gps.hasFix()).isFalse();
    assertThat(gps.minDistanceMm(P)).isZero();
    assertThat(gps.maxDistanceMm(P)).isInfinite();
    assertThat(gps.errorMm()).isInfinite();
    assertThat(gps.ageNs()).isEqualTo(Long.MAX_VALUE);
    assertThat(gps.isClearOf(ZONE, 1)).isFalse();
    assertThat(gps.clearanceMm(ZONE, 1)).isEqualTo(Double.NEGATIVE_INFINITY);
    assertThat(gps.isClearOf(new Nowhere(), 1)).isTrue();
  }

  @Test
  void distancesHaveTheErrorOnTheSafeSide() {
    fix(0, 0);
    assertThat(gps.errorMm()).isCloseTo(4, within(1e-3));
    assertThat(gps.minDistanceMm(P)).isCloseTo(996, within(1e-3));
    assertThat(gps.maxDistanceMm(P)).isCloseTo(1_004, within(1e-3));
    assertThat(gps.minDistanceMm(new Point(3, 0))).isZero();
    assertThat(gps.clearanceMm(ZONE, 165)).isCloseTo(731, within(1e-3));
    assertThat(gps.isClearOf(ZONE, 895)).isTrue();
    assertThat(gps.isClearOf(ZONE, 896.5)).isFalse();
  }

  @Test
  void fixesAreCountedByWhatBecameOfThem() {
    world.runMs(100);
    fix(0, world.nowNs());
    world.runMs(30);
    assertThat(gps.ageNs()).isEqualTo(30_000_000);
    fix(0, world.nowNs() - 50_000_000);
    assertThat(gps.outdated()).as("older than the last").isEqualTo(1);
    fix(500, world.nowNs());
    assertThat(gps.contradictions()).as("half a metre in 30 ms, without a command").isEqualTo(1);
    assertThat(gps.isContradicted()).isTrue();
    assertThat(gps.pose().xMm()).isEqualTo(0);
    world.runMs(10);
    fix(0, world.nowNs());
    assertThat(gps.isContradicted()).isFalse();
    assertThat(gps.fixes()).isEqualTo(4);
  }
}

package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;

/** Motion control, safety (paper, section 4.1): the body is always outside the region to avoid. */
class AvoidGuardTest {

  private static final double RADIUS_MM = 165;

  @Test
  void aTargetInTheRegionFailsAtOnce() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region region = new Circle(new Point(1000, 0), 100);
    assertThat(world.goTo(new Point(800, 0), region, 0)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).contains("target is in the region");
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void aRegionInTheWayStopsShortAndFails() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region region = new Circle(new Point(1000, 0), 100);
    assertThat(world.goTo(new Point(2000, 0), region, 20_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).contains("in the way");
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    assertThat(world.nearestToAvoidMm).isBetween(RADIUS_MM, RADIUS_MM + 20);
  }

  @Test
  void aRegionBesideTheWayDoesNotStop() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region beside =
        Union.of(new Rectangle(-500, 190, 3000, 500), new Rectangle(-500, -500, 3000, -190));
    assertThat(world.goTo(new Point(2000, 0), beside, 20_000)).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void whoStandsInTheRegionMayTurnButNotDrive() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 3));
    Region here = new Circle(new Point(0, 0), 100);
    assertThat(world.goTo(new Point(2000, 0), here, 20_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.truth.at()).isEqualTo(new Point(0, 0));
  }
}

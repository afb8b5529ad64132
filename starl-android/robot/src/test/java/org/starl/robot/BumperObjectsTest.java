package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.motion.Location;
import org.starl.robot.create.Wheelbase;

/** What a drive's bumper says about objects: a robot at (1000, 0) that faces along y. */
class BumperObjectsTest {

  private static final double RADIUS_MM = 165;
  private static final double ERROR_MM = 5;

  private Bumps bumps = Bumps.NONE;
  private List<Double> nearRad = List.of();

  private final BumperObjects sensor =
      new BumperObjects(
          new Drive(),
          RADIUS_MM,
          () -> new Location.Known(new Pose(1000, 0, StrictMath.PI / 2), ERROR_MM, 0.01, 0, 0));

  private static Point surface(double bearingRad, double reachMm) {
    double headingRad = StrictMath.PI / 2 + bearingRad;
    return new Point(
        1000 + reachMm * StrictMath.cos(headingRad), reachMm * StrictMath.sin(headingRad));
  }

  @Test
  void nothingIsShownWithoutAContact() {
    sensor.require(0);
    assertThat(sensor.sensed()).isEmpty();
  }

  @Test
  void aContactIsWithinTheErrorBoundOfItsSighting() {
    sensor.require(0);
    for (double bearing = 0; bearing <= StrictMath.PI / 2; bearing += 0.05) {
      bumps = Bumps.LEFT;
      assertIn(surface(bearing, RADIUS_MM + ERROR_MM));
      bumps = Bumps.RIGHT;
      assertIn(surface(-bearing, RADIUS_MM + ERROR_MM));
    }
    bumps = Bumps.BOTH;
    assertThat(sensor.sensed()).hasSize(2);
  }

  @Test
  void aNearObjectIsWithinTheErrorBoundOfItsSighting() {
    nearRad = List.of(StrictMath.PI / 12);
    for (double beyondMm = 0; beyondMm <= Wheelbase.NEAR_MM; beyondMm += 10) {
      assertIn(surface(StrictMath.PI / 12 + StrictMath.PI / 6, RADIUS_MM + beyondMm));
    }
  }

  private void assertIn(Point surface) {
    assertThat(sensor.sensed())
        .singleElement()
        .satisfies(sighting -> {
          assertThat(sighting.name()).isEmpty();
          assertThat(sighting.at().distanceMm(surface)).isLessThan(sighting.errorMm());
          assertThat(sighting.errorMm()).isLessThan(250);
        });
  }

  @Test
  void anAppThatNeedsARangeIsRefused() {
    assertThatThrownBy(() -> sensor.require(600))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("600 mm");
  }

  /** A drive of which only the bumper works. */
  private final class Drive implements Wheelbase {

    @Override
    public void drive(WheelCommand command) {}

    @Override
    public Bumps bumps() {
      return bumps;
    }

    @Override
    public List<Double> nearRad() {
      return nearRad;
    }

    @Override
    public void onBump(Runnable receiver) {}

    @Override
    public void fixed(Fix fix) {}

    @Override
    public void doubted() {}

    @Override
    public void emergencyStop() {}

    @Override
    public void release() {}

    @Override
    public void close() {}
  }
}

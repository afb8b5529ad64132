package org.starl.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.starl.body.Bumps;
import org.starl.geometry.Point;
import org.starl.motion.Location;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Sighting;
import org.starl.robot.create.Wheelbase;

/**
 * An object sensor made of a drive's bump and proximity sensors: shows, without names, that an
 * object or a wall is at a side of the body. It has two classes of distance: touching, and near. The
 * places are those of the robot's estimate at the time of the call.
 */
final class BumperObjects implements ObjectSensor {

  /** A bump switch closes for contacts on its half of the front, this far to each side of its middle. */
  private static final double BUMP_RAD = StrictMath.PI / 4;

  private static final double NEAR_RAD = StrictMath.PI / 6;

  private final Wheelbase wheels;
  private final double radiusMm;
  private final Supplier<Location> location;

  /**
   * @param radiusMm of the body
   * @param location the robot's estimate
   */
  BumperObjects(Wheelbase wheels, double radiusMm, Supplier<Location> location) {
    this.wheels = wheels;
    this.radiusMm = radiusMm;
    this.location = location;
  }

  @Override
  public void require(double rangeMm) {
    if (rangeMm > 0) {
      throw new IllegalStateException(
          "a bumper senses only what is at the body: expected, for a range of "
              + Math.round(rangeMm)
              + " mm, objects: positions");
    }
  }

  @Override
  public List<Sighting> sensed() {
    List<Sighting> sensed = new ArrayList<>();
    if (location.get() instanceof Location.Known here) {
      Bumps bumps = wheels.bumps();
      if (bumps == Bumps.LEFT || bumps == Bumps.BOTH) {
        sensed.add(sighting(here, BUMP_RAD, 0, BUMP_RAD));
      }
      if (bumps == Bumps.RIGHT || bumps == Bumps.BOTH) {
        sensed.add(sighting(here, -BUMP_RAD, 0, BUMP_RAD));
      }
      for (double bearingRad : wheels.nearRad()) {
        sensed.add(sighting(here, bearingRad, Wheelbase.NEAR_MM, NEAR_RAD));
      }
    }
    return sensed;
  }

  /** A surface between the body and {@code beyondMm} from it, within a sector of the front. */
  private Sighting sighting(
      Location.Known here, double bearingRad, double beyondMm, double sectorRad) {
    double reachMm = radiusMm + beyondMm / 2;
    double headingRad = here.pose().headingRad() + bearingRad;
    Point offset =
        new Point(reachMm * StrictMath.cos(headingRad), reachMm * StrictMath.sin(headingRad));
    double offRad = Math.min(StrictMath.PI, sectorRad + here.errorRad());
    double chordMm = 2 * (radiusMm + beyondMm) * StrictMath.sin(offRad / 2);
    return new Sighting("", here.pose().at().plus(offset), here.errorMm() + chordMm + beyondMm / 2);
  }
}

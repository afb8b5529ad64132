package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Sighting;

/** The contract of {@link ObjectSensor} with named objects. Everywhere a robot stands at (0, 0). */
abstract class ObjectSensorContract {

  static final double RANGE_MM = 600;

  /** A wall across the x axis, from (200, -100) to (210, 100). */
  static final Obstacles WALL =
      Obstacles.of(
          Obstacle.body(
              new Point(200, -100),
              new Point(210, -100),
              new Point(210, 100),
              new Point(200, 100)));

  /** The sensor of a robot on a floor with {@link #WALL} and these objects. */
  abstract ObjectSensor sensor(List<ItemPosition> objects);

  private List<String> sensed(ItemPosition... objects) {
    ObjectSensor sensor = sensor(List.of(objects));
    sensor.require(RANGE_MM);
    return sensor.sensed().stream().map(Sighting::name).toList();
  }

  @Test
  void objectsInRangeAreShownInAllDirections() {
    assertThat(
            sensed(
                new ItemPosition("ahead", 0, 600),
                new ItemPosition("behind", 0, -599),
                new ItemPosition("near", -1, 0)))
        .containsExactlyInAnyOrder("ahead", "behind", "near");
  }

  @Test
  void anObjectOutOfRangeIsNotShown() {
    assertThat(sensed(new ItemPosition("far", 0, 601))).isEmpty();
  }

  @Test
  void anObjectBehindAWallIsNotShown() {
    assertThat(sensed(new ItemPosition("hidden", 400, 0), new ItemPosition("beside", 400, 250)))
        .containsExactly("beside");
  }

  @Test
  void aSightingHasTheObjectsPlace() {
    ObjectSensor sensor = sensor(List.of(new ItemPosition("box", -300, 40)));
    sensor.require(RANGE_MM);
    Sighting sighting = sensor.sensed().get(0);
    assertThat(sighting.at().distanceMm(new Point(-300, 40)))
        .isLessThanOrEqualTo(sighting.errorMm());
  }

  @Test
  void aProgramThatDoesNotSayItsRangeIsRefused() {
    assertThatThrownBy(() -> sensor(List.of()).sensed())
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("require");
  }
}

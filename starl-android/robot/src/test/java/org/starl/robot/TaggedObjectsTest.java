package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Fix;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.motion.Location;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Sighting;

/** Objects of a position feed in which robots are bodies too. */
class TaggedObjectsTest extends ObjectSensorContract {

  private static final long S = 1_000_000_000L;
  private static final double ERROR_MM = 5;

  private final SortedMap<String, Fix> bodies = new TreeMap<>();
  private long nowNs = 60 * S;
  private Location location = new Location.Known(new Pose(0, 0, 0), 7, 0.01, nowNs, nowNs);

  private ObjectSensor sensor() {
    return new TaggedObjects(
        () -> bodies, Set.of("bot0", "bot1"), () -> location, WALL, () -> nowNs);
  }

  @Override
  ObjectSensor sensor(List<ItemPosition> objects) {
    objects.forEach(this::measure);
    return sensor();
  }

  private void measure(ItemPosition body) {
    bodies.put(body.name(), new Fix(body.pose(), nowNs, ERROR_MM, 0.02));
  }

  @Test
  void robotsAreNoObjects() {
    measure(new ItemPosition("bot0", 0, 0));
    measure(new ItemPosition("bot1", 0, 300));
    ObjectSensor sensor = sensor(List.of(new ItemPosition("box", 0, 400)));
    sensor.require(RANGE_MM);
    assertThat(sensor.sensed()).extracting(Sighting::name).containsExactly("box");
  }

  @Test
  void aSightingHasTheErrorBoundOfItsMeasurement() {
    ObjectSensor sensor = sensor(List.of(new ItemPosition("box", 0, 400)));
    sensor.require(RANGE_MM);
    assertThat(sensor.sensed().get(0).errorMm()).isEqualTo(ERROR_MM);
  }

  @Test
  void anObjectThatTheCamerasHaveLostIsShownForFiveSeconds() {
    ObjectSensor sensor = sensor(List.of(new ItemPosition("box", 0, 400)));
    sensor.require(RANGE_MM);
    nowNs += 5 * S;
    assertThat(sensor.sensed()).hasSize(1);
    nowNs++;
    assertThat(sensor.sensed()).isEmpty();
  }

  @Test
  void aRobotThatDoesNotKnowItsPlaceSensesNothing() {
    ObjectSensor sensor = sensor(List.of(new ItemPosition("box", 0, 400)));
    sensor.require(RANGE_MM);
    location = new Location.Unknown();
    assertThat(sensor.sensed()).isEmpty();
  }
}

package org.starl.platform;

import java.util.List;

/**
 * Senses objects on the floor that are no robots. Implementations: the simulated world, tagged
 * bodies in a position feed, a Create's bumper. Strand only; no call waits.
 */
public interface ObjectSensor {

  /** Of a robot without an object sensor: every call throws {@link IllegalStateException}. */
  ObjectSensor NONE = new NoObjectSensor();

  /**
   * States the range that the program needs: call it once, when the app is created. Then a robot
   * with a worse sensor does not start, instead of finding nothing.
   *
   * @param rangeMm the sensor shall show each object whose centre is within this distance of the
   *     robot's centre, in all directions, with no known obstacle on the straight line between,
   *     and no other objects; 0 for a sensor that shows only what is at the robot's body, on some
   *     sides
   * @throws IllegalStateException if the robot has no sensor, or not of that range; one line
   */
  void require(double rangeMm);

  /**
   * The objects that it senses now, in an order that does not change. At the edge of the range and
   * of an obstacle's shadow, {@link Sighting#errorMm} and the error of the robot's position decide.
   *
   * @throws IllegalStateException before {@link #require}
   */
  List<Sighting> sensed();
}

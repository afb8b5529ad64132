package org.starl.platform;

import java.util.List;

/** The object sensor of a robot that has none. */
final class NoObjectSensor implements ObjectSensor {

  @Override
  public void require(double rangeMm) {
    throw none();
  }

  @Override
  public List<Sighting> sensed() {
    throw none();
  }

  private static IllegalStateException none() {
    return new IllegalStateException(
        "this robot has no object sensor: expected Simulation.Builder.objects in a simulation, or"
            + " objects: under the robot in a deployment file");
  }
}

package org.starl.platform;

import java.util.Collections;
import java.util.SortedMap;
import org.starl.geometry.Fix;
import org.starl.id.RobotId;

/** Position measurements (fixes) from an external system: OptiTrack, GPS or the simulated world. */
public interface Positioning {

  /** Sets the one receiver of this robot's fixes; it is called on the strand. Call it once. */
  void onFix(Receiver receiver);

  /**
   * The newest fix of each robot that the system has measured, this one included, with times on this
   * robot's clock. An old time means that the system no longer sees that robot. Strand only.
   */
  default SortedMap<RobotId, Fix> newest() {
    return Collections.emptySortedMap();
  }

  /**
   * States what this robot's program needs; call it before the first fix. The simulator places robots
   * accordingly, or refuses the run. Real robots stand where they are: nothing happens.
   */
  default void require(StartNeeds needs) {}

  /** Receives a fix, on the strand. */
  @FunctionalInterface
  interface Receiver {
    void fixed(Fix fix);
  }
}

package org.starl.primitives.geocast;

import org.starl.geometry.Region;
import org.starl.id.RobotId;

/** The effects of a {@link GeocastProtocol}, and its source of positions. */
interface GeocastPort<T> {

  /** Sends a copy to every robot in reach, best effort. */
  void broadcast(GeocastMessage.Copy<T> copy);

  /** Sends an acknowledgement, best effort. */
  void acknowledge(RobotId to, GeocastMessage.Ack<T> ack);

  /**
   * The certain distance of this robot's centre from the border inside {@code area}, minus the
   * position error; at most 0 if the robot may be outside.
   */
  double surelyInsideMm(Region area);

  /** Hands the message to the app, once. */
  void deliver(GeocastId id, T message);

  /** A copy was neither delivered nor acknowledged. */
  void dismissed(GeocastId id, Dismissal why);
}

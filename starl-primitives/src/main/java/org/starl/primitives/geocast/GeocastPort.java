package org.starl.primitives.geocast;

import org.starl.geometry.Region;
import org.starl.id.RobotId;

/** Where a {@link GeocastProtocol}'s effects go, and where it asks for its place. */
interface GeocastPort<T> {

  /** Sends a copy to every robot in reach, best effort. */
  void broadcast(GeocastMessage.Copy<T> copy);

  /** Sends an acknowledgement, best effort. */
  void acknowledge(RobotId to, GeocastMessage.Ack<T> ack);

  /**
   * This robot's centre is at least this deep inside {@code area}, whatever its fix's error; not
   * above 0 if it may be outside.
   */
  double surelyInsideMm(Region area);

  /** Hands the message to the app, once. */
  void deliver(GeocastId id, T message);

  /** A copy was not delivered, nor acknowledged. */
  void dismissed(GeocastId id, Dismissal why);

  /** Why a copy is not delivered. */
  enum Dismissal {
    /** This robot may be outside the area. */
    OUTSIDE,
    /** The interval is over, or may be. */
    LATE,
    /** It was sent in the future: the clocks differ by more than they may. */
    EARLY
  }
}

package org.starl.motion;

import org.starl.body.Bumps;

/**
 * What the robot knew at a contact: its location, and which bump sensors were closed. A closed
 * sensor shows that something was touched, not exactly where.
 *
 * @param at the robot's location with error bounds
 * @param bumps not {@code NONE}
 */
public record Contact(Location.Known at, Bumps bumps) {

  public Contact {
    if (!bumps.any()) {
      throw new IllegalArgumentException("contact without a closed sensor");
    }
  }
}

package org.starl.motion;

import org.starl.body.Bumps;

/**
 * A contact as the robot knows it: its location, and the closed bump sensors. A closed sensor shows
 * that the body touches an object, not exactly where.
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

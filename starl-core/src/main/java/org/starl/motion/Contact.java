package org.starl.motion;

import org.starl.body.Bumps;

/**
 * What the robot knew when it touched something: where it was, and which bump sensors were closed. Of
 * what it touched that says: a closed sensor has something before it, not where.
 *
 * @param at the robot's place, with its error bounds
 * @param bumps not {@code NONE}
 */
public record Contact(Location.Known at, Bumps bumps) {

  public Contact {
    if (!bumps.any()) {
      throw new IllegalArgumentException("contact without a closed sensor");
    }
  }
}

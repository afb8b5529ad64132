package org.starl.ros2;

import org.starl.body.Bumps;

/**
 * What a base feels.
 *
 * @param cliff whether it sees no floor ahead
 * @param wheelDrop whether a wheel hangs down
 */
record Contacts(Bumps bumps, boolean cliff, boolean wheelDrop) {

  static final Contacts NONE = new Contacts(Bumps.NONE, false, false);

  static Contacts of(boolean left, boolean right, boolean cliff, boolean wheelDrop) {
    return new Contacts(Bumps.of(left, right), cliff, wheelDrop);
  }
}

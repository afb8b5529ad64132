package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;

/**
 * The tubes of one robot.
 *
 * @param version grows with every change, also over a restart
 * @param held the tubes that it may occupy
 * @param wanted the tube that it requests in addition, or none
 */
record Holding(long version, List<Tube> held, List<Tube> wanted) {

  static final Holding NONE = new Holding(0, List.of(), List.of());

  /** The largest number of held tubes. */
  static final int MAX_TUBES = 2;

  Holding {
    held = List.copyOf(held);
    wanted = List.copyOf(wanted);
    if (version < 0 || held.size() > MAX_TUBES || wanted.size() > 1) {
      throw new IllegalArgumentException(
          "version " + version + ", " + held.size() + " tubes held, " + wanted.size() + " wanted");
    }
  }

  List<Tube> all() {
    List<Tube> all = new ArrayList<>(held);
    all.addAll(wanted);
    return all;
  }

  /** The state after a restart: without wanted tubes, and newer than all earlier versions. */
  Holding inBoot(int boot) {
    return new Holding((long) boot << Integer.SIZE, held, List.of());
  }

  Holding withoutWanted() {
    return new Holding(version, held, List.of());
  }
}

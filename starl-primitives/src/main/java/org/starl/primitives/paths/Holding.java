package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;

/**
 * All that one robot has to say of its tubes.
 *
 * @param version grows with every change; a restarted robot goes on above its older ones
 * @param held what it may occupy
 * @param wanted what it asks for beside that; one tube or none
 */
record Holding(long version, List<Tube> held, List<Tube> wanted) {

  static final Holding NONE = new Holding(0, List.of(), List.of());

  /** In each list, at most. */
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

  /** The same as a later incarnation says it: above all versions of earlier ones. */
  Holding inBoot(int boot) {
    return new Holding((long) boot << Integer.SIZE, held, List.of());
  }

  Holding withoutWanted() {
    return new Holding(version, held, List.of());
  }
}

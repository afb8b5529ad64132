package org.starl.primitives.motion;

import java.util.SortedSet;
import org.starl.spec.automaton.Sets;

/**
 * A place of the automaton: of a body, represented by the areas that the body is in and the targets
 * that it is near; or a target, represented by its command. The monitor decides both with its
 * tolerances.
 *
 * @param avoided the commands whose area to avoid contains it; immutable
 * @param near the commands whose target it is near; immutable
 * @param command the command whose target it is; 0 for a body's place
 */
public record Place(SortedSet<Long> avoided, SortedSet<Long> near, long command) {

  /** In no area, near no target. */
  public static final Place ELSEWHERE = of(Sets.emptyset(), Sets.emptyset());

  /** The place of a body. */
  static Place of(SortedSet<Long> avoided, SortedSet<Long> near) {
    return new Place(avoided, near, 0);
  }

  /** The target of a command. */
  static Place target(long command) {
    return new Place(Sets.emptyset(), Sets.emptyset(), command);
  }

  /** Whether a body here is near {@code target}: the theory's parameter. */
  boolean isNear(Place target) {
    return near.contains(target.command);
  }

  @Override
  public String toString() {
    return command == 0 ? "in " + avoided + ", near " + near : Long.toString(command);
  }
}

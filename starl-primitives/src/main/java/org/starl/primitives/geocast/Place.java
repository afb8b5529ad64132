package org.starl.primitives.geocast;

import java.util.SortedSet;
import org.starl.spec.automaton.Sets;

/**
 * A place of the automaton, represented by the areas that contain it: the automaton asks nothing else
 * of it, and the monitor decides with its tolerances what lies in which area.
 *
 * @param areas the ids of their geocasts; immutable
 */
public record Place(SortedSet<String> areas) {

  /** A place in no area. */
  public static final Place ELSEWHERE = new Place(Sets.emptyset());

  /** This place, also in {@code area}. */
  Place in(Area area) {
    return new Place(Sets.add(area.id(), areas));
  }

  /** This place, without {@code area}. */
  Place without(Area area) {
    return !areas.contains(area.id()) ? this : new Place(Sets.remove(area.id(), areas));
  }

  @Override
  public String toString() {
    return areas.toString();
  }
}

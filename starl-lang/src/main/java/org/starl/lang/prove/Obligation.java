package org.starl.lang.prove;

import java.util.List;
import org.starl.lang.tree.Pos;

/**
 * What must hold so that an expression has a value, or an action an effect.
 *
 * @param condition closed, for Z3
 */
record Obligation(String condition, Place place) {

  /**
   * An operation that needs something. With few elements a quantifier is written out: then one place
   * has an obligation for each of them, or none that is not true at once.
   *
   * @param otherwise what is wrong where it does not hold
   * @param pos of the operation
   */
  record Place(String otherwise, Pos pos) {

    List<Obligation> among(List<Obligation> all) {
      return all.stream().filter(each -> each.place.equals(this)).toList();
    }
  }

  static List<Place> places(List<Obligation> all) {
    return all.stream().map(Obligation::place).distinct().toList();
  }
}

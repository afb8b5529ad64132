package org.starl.primitives.geocast;

/**
 * An area of the automaton, represented by the id of the geocast that is sent to it.
 *
 * @param id empty for the area of no geocast
 */
public record Area(String id) {

  /** The area of no geocast: it contains no place. */
  public static final Area NONE = new Area("");

  /** Whether the place lies in it. */
  public boolean contains(Place place) {
    return place.areas().contains(id);
  }

  @Override
  public String toString() {
    return id;
  }
}

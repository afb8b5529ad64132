package org.starl.primitives.geocast;

/**
 * An area of the automaton, represented by the id of the geocast that is sent to it.
 *
 * @param id empty for the area of no geocast, {@code everywhere} for that of all places
 */
public record Area(String id) {

  /** The area of no geocast: it contains no place. */
  public static final Area NONE = new Area("");

  /** The area of a broadcast: it contains every place. */
  public static final Area EVERYWHERE = new Area("everywhere");

  /** The area of a geocast. */
  static Area of(GeocastId m) {
    return new Area(m.toString());
  }

  /** Whether the place lies in it. */
  public boolean contains(Place place) {
    return equals(EVERYWHERE) || place.areas().contains(id);
  }

  @Override
  public String toString() {
    return id;
  }
}

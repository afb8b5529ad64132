package org.starl.primitives.motion;

/**
 * An area to avoid, of the automaton, represented by the number of its command.
 *
 * @param command 0 for no command
 */
public record Area(long command) {

  /** Nothing to avoid. */
  public static final Area NONE = new Area(0);

  /** Whether a body at the place is in it. */
  public boolean contains(Place place) {
    return place.avoided().contains(command);
  }

  @Override
  public String toString() {
    return Long.toString(command);
  }
}

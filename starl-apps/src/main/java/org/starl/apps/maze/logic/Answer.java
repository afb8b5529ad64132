package org.starl.apps.maze.logic;

/** What becomes of a goal. */
public enum Answer {
  REACHED,
  /** There is none for a body that is wider by {@link Errand#MARGIN_MM}. */
  NO_WAY,
  /** It squeezed through a gap that is narrower, and does not find back. */
  GAVE_UP
}

package org.starl.apps.maze.logic;

/** The result for one goal. */
public enum Answer {
  REACHED,
  /** There is no way for a body that is wider by {@link MazeTask#MARGIN_MM}. */
  NO_WAY,
  /** The robot went through a gap that is narrower than that, and finds no way back. */
  GAVE_UP
}

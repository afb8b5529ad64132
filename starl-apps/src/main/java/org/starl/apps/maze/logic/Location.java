package org.starl.apps.maze.logic;

/** What a robot in a maze is about. */
public enum Location {
  START,
  /** Stands at its start or at a goal, holds nothing, and looks for a way to the next goal. */
  CHOOSE,
  ASK,
  ASK_WAIT,
  DRIVE,
  /** Has bumped, and learns from it. */
  FEEL,
  /** Stands somewhere in the blocks that it holds, and looks for a way on. */
  PLAN_AGAIN,
  /** Goes back on its trail, from where no way leads on. */
  RETREAT,
  DONE
}

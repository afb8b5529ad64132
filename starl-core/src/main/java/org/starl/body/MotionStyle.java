package org.starl.body;

/** Which motion automaton drives. */
public enum MotionStyle {
  /** The original's automaton for a differential drive with bounded turning speed. */
  UNICYCLE,
  /** Turns at once, drives straight at full speed, stops on the target. */
  IDEAL
}

package org.starl.body;

/** The motion automaton. */
public enum MotionStyle {
  /** The original's automaton for a differential drive with bounded turning speed. */
  UNICYCLE,
  /** Turns at once, drives straight at full speed, stops on the target. */
  IDEAL
}

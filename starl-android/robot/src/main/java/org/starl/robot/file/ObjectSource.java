package org.starl.robot.file;

/** Senses objects that are no robots. */
public enum ObjectSource {
  /** Tagged bodies in the position feed. */
  POSITIONS,
  /** The Create's bumper: what touches it or is near it. */
  BUMPER
}

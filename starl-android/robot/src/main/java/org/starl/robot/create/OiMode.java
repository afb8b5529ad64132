package org.starl.robot.create;

/** The robot's modes; packet 35 tells them by their place here. */
public enum OiMode {
  /** Hears nothing but the start command. */
  OFF,
  /** Tells its sensors, and does not let itself be driven. */
  PASSIVE,
  /** Is driven, but falls to PASSIVE at a cliff ahead, a wheel that drops, a charger. */
  SAFE,
  /** Is driven, over the edge of a table too. */
  FULL,
  /** A value that no specification has; some Create 2 tell 32 when they have left SAFE. */
  UNKNOWN;

  static OiMode of(int value) {
    return switch (value) {
      case 0 -> OFF;
      case 1 -> PASSIVE;
      case 2 -> SAFE;
      case 3 -> FULL;
      default -> UNKNOWN;
    };
  }
}

package org.starl.robot.create;

/** The robot's modes; packet 35 numbers them in this order. */
public enum OiMode {
  /** Accepts only the start command. */
  OFF,
  /** Sends its sensors, but accepts no driving. */
  PASSIVE,
  /** Can be driven, but falls back to PASSIVE at a cliff ahead, a wheel drop or a charger. */
  SAFE,
  /** Can be driven, even over the edge of a table. */
  FULL,
  /** A value outside the specifications; some Create 2 send 32 when they have left SAFE. */
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

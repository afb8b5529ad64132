package org.starl.robot.create;

/**
 * Settings of a Create's driver. Immutable; times in ms.
 *
 * @param mode SAFE, in which the robot itself stops at cliffs and when lifted, or FULL
 * @param commandTimeoutMs the wheels stop if the program has not repeated its command for this time
 * @param positionTimeoutMs the wheels stop if the last fix is older; 0: fixes are not checked
 * @param sensorTimeoutMs the wheels stop if no sensor frame arrived for this time; the period is 15 ms
 * @param recoverAfterMs the driver restores the mode when the cause that ended it (a wheel drop, a
 *     charger) has been absent for this time
 * @param linkTimeoutMs a link on which sensor frames have stopped for this time is closed, and a new
 *     one opened; the first frame may take {@link #OPEN_MS}
 * @param tellAfterMs silence of the sensors for this time is logged: the deployment's reaction time,
 *     within which commands are promised to be in effect
 * @param retryMs time between two attempts to open a link; the first attempt after a link that worked
 *     is made at once
 * @param maxWheelMmPerS greatest commanded speed of a wheel
 */
public record CreateSettings(
    CreateModel model,
    OiMode mode,
    long commandTimeoutMs,
    long positionTimeoutMs,
    long sensorTimeoutMs,
    long recoverAfterMs,
    long linkTimeoutMs,
    long tellAfterMs,
    long retryMs,
    int maxWheelMmPerS) {

  /** The longest time until the first frame of a new link. */
  public static final long OPEN_MS = 3000;

  public CreateSettings {
    if (mode != OiMode.SAFE && mode != OiMode.FULL) {
      throw new IllegalArgumentException("mode " + mode + ": expected SAFE or FULL");
    }
    atLeast("commandTimeoutMs", commandTimeoutMs, 1);
    atLeast("positionTimeoutMs", positionTimeoutMs, 0);
    atLeast("sensorTimeoutMs", sensorTimeoutMs, 2 * Packets.STREAM_PERIOD_MS);
    atLeast("recoverAfterMs", recoverAfterMs, 0);
    atLeast("linkTimeoutMs", linkTimeoutMs, 100);
    atLeast("tellAfterMs", tellAfterMs, 1);
    atLeast("retryMs", retryMs, 1);
    if (maxWheelMmPerS < 1 || maxWheelMmPerS > CreateModel.MAX_WHEEL_MM_PER_S) {
      throw new IllegalArgumentException(
          "maxWheelMmPerS " + maxWheelMmPerS + ": expected 1 to " + CreateModel.MAX_WHEEL_MM_PER_S);
    }
  }

  /**
   * The defaults: SAFE mode, 300 ms for commands (five steps of the motion automaton), 500 ms for
   * fixes, 100 ms for sensors, 500 ms before a mode is restored, 3 s for the link, 200 ms until a silence is logged.
   */
  public static CreateSettings of(CreateModel model) {
    return new CreateSettings(
        model, OiMode.SAFE, 300, 500, 100, 500, OPEN_MS, 200, 500, CreateModel.MAX_WHEEL_MM_PER_S);
  }

  /** The same settings with these timeouts and this greatest speed. */
  public CreateSettings withLimits(
      long newCommandTimeoutMs,
      long newPositionTimeoutMs,
      long newLinkTimeoutMs,
      long newTellAfterMs,
      int newMaxWheelMmPerS) {
    return new CreateSettings(
        model,
        mode,
        newCommandTimeoutMs,
        newPositionTimeoutMs,
        sensorTimeoutMs,
        recoverAfterMs,
        newLinkTimeoutMs,
        newTellAfterMs,
        retryMs,
        newMaxWheelMmPerS);
  }

  private static void atLeast(String name, long value, long least) {
    if (value < least) {
      throw new IllegalArgumentException(name + " " + value + ": expected at least " + least);
    }
  }
}

package org.starl.robot.create;

/**
 * How a Create is driven. Immutable; times in ms.
 *
 * @param mode SAFE, in which the robot itself stops at cliffs and when lifted, or FULL
 * @param commandTimeoutMs a program that has not repeated its command for so long is stopped
 * @param positionTimeoutMs wheels stop when the last fix is older; 0: nobody looks at fixes
 * @param sensorTimeoutMs wheels stop when no frame of sensors came for so long; one comes every 15 ms
 * @param recoverAfterMs the robot is brought back to its mode when what put it out of it (a wheel
 *     that dropped, a charger) has been gone for so long
 * @param linkTimeoutMs a link over which no sensors came for so long is given up for another
 * @param retryMs from one attempt to open a link to the next; after a link over which the robot was
 *     heard the first is made at once
 * @param maxWheelMmPerS no wheel is told to turn faster
 */
public record CreateSettings(
    CreateModel model,
    OiMode mode,
    long commandTimeoutMs,
    long positionTimeoutMs,
    long sensorTimeoutMs,
    long recoverAfterMs,
    long linkTimeoutMs,
    long retryMs,
    int maxWheelMmPerS) {

  public CreateSettings {
    if (mode != OiMode.SAFE && mode != OiMode.FULL) {
      throw new IllegalArgumentException("mode " + mode + ": expected SAFE or FULL");
    }
    atLeast("commandTimeoutMs", commandTimeoutMs, 1);
    atLeast("positionTimeoutMs", positionTimeoutMs, 0);
    atLeast("sensorTimeoutMs", sensorTimeoutMs, 2 * Packets.STREAM_PERIOD_MS);
    atLeast("recoverAfterMs", recoverAfterMs, 0);
    atLeast("linkTimeoutMs", linkTimeoutMs, 100);
    atLeast("retryMs", retryMs, 1);
    if (maxWheelMmPerS < 1 || maxWheelMmPerS > CreateModel.MAX_WHEEL_MM_PER_S) {
      throw new IllegalArgumentException(
          "maxWheelMmPerS " + maxWheelMmPerS + ": expected 1 to " + CreateModel.MAX_WHEEL_MM_PER_S);
    }
  }

  /**
   * What fits most: SAFE mode, 300 ms for commands (five steps of the motion automaton), 500 ms for
   * fixes, 100 ms for sensors, 500 ms before a mode is taken up again, 3 s for the link.
   */
  public static CreateSettings of(CreateModel model) {
    return new CreateSettings(
        model, OiMode.SAFE, 300, 500, 100, 500, 3000, 500, CreateModel.MAX_WHEEL_MM_PER_S);
  }

  /** These, in another mode. */
  public CreateSettings withMode(OiMode newMode) {
    return new CreateSettings(
        model,
        newMode,
        commandTimeoutMs,
        positionTimeoutMs,
        sensorTimeoutMs,
        recoverAfterMs,
        linkTimeoutMs,
        retryMs,
        maxWheelMmPerS);
  }

  /** These, with other times for what goes stale. */
  public CreateSettings withTimeouts(long newCommandTimeoutMs, long newPositionTimeoutMs) {
    return new CreateSettings(
        model,
        mode,
        newCommandTimeoutMs,
        newPositionTimeoutMs,
        sensorTimeoutMs,
        recoverAfterMs,
        linkTimeoutMs,
        retryMs,
        maxWheelMmPerS);
  }

  private static void atLeast(String name, long value, long least) {
    if (value < least) {
      throw new IllegalArgumentException(name + " " + value + ": expected at least " + least);
    }
  }
}

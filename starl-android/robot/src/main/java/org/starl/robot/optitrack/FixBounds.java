package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.time.Time;

/**
 * Assumptions on a measuring system and its robots, from which every fix gets a valid error bound. The
 * uncertainty of a fix's time counts as distance at the robot's top speed.
 *
 * @param errorFloorMm no position is better than this, whatever the system says
 * @param errorFloorRad no heading is better than this
 * @param errorScale the error bound is this multiple of the mean error of a rigid body's markers
 * @param markerSpreadMm the markers' distance from the body's pivot; an error of them turns the
 *     body by at most their bound divided by this
 * @param maxSpeedMmPerS no robot drives faster
 * @param maxTurnRadPerS no robot turns faster
 * @param maxDelayMs largest delay of the fastest datagram in each 5 s; used if the server answers no questions
 *     about its clock
 * @param maxLatencyMs largest time from exposure until the frame is sent; used if the server does not
 *     send the time of exposure
 * @param maxAgeMs older measurements are stale, and dropped
 * @param stillMs this time after its last fix a robot stands still; a fix that is too far from the one
 *     before it is used only if poses at the new place were consistent for this time. 0: each fix is
 *     used
 */
public record FixBounds(
    double errorFloorMm,
    double errorFloorRad,
    double errorScale,
    double markerSpreadMm,
    double maxSpeedMmPerS,
    double maxTurnRadPerS,
    long maxDelayMs,
    long maxLatencyMs,
    long maxAgeMs,
    long stillMs) {

  /** For an iRobot Create, which drives 500 mm/s at most, under a well calibrated system. */
  public static final FixBounds DEFAULT = new FixBounds(5, 0.02, 3, 80, 500, 4.3, 20, 30, 250, 0);

  private static final long MS_PER_HOUR = 3_600_000;

  public FixBounds {
    check("errorFloorMm", errorFloorMm, true);
    check("errorFloorRad", errorFloorRad, true);
    check("errorScale", errorScale, true);
    check("markerSpreadMm", markerSpreadMm, false);
    check("maxSpeedMmPerS", maxSpeedMmPerS, true);
    check("maxTurnRadPerS", maxTurnRadPerS, true);
    checkMs("maxDelayMs", maxDelayMs);
    checkMs("maxLatencyMs", maxLatencyMs);
    checkMs("maxAgeMs", maxAgeMs);
    checkMs("stillMs", stillMs);
  }

  /** The same bounds with these smallest errors. */
  public FixBounds withErrors(double newErrorFloorMm, double newErrorFloorRad) {
    return new FixBounds(
        newErrorFloorMm,
        newErrorFloorRad,
        errorScale,
        markerSpreadMm,
        maxSpeedMmPerS,
        maxTurnRadPerS,
        maxDelayMs,
        maxLatencyMs,
        maxAgeMs,
        stillMs);
  }

  /**
   * The same bounds for robots of these limits, with a check of jumps.
   *
   * @param speedMmPerS of a wheel, at most
   */
  public FixBounds withMotion(double speedMmPerS, long newStillMs) {
    return new FixBounds(
        errorFloorMm,
        errorFloorRad,
        errorScale,
        markerSpreadMm,
        speedMmPerS,
        maxTurnRadPerS * speedMmPerS / maxSpeedMmPerS,
        maxDelayMs,
        maxLatencyMs,
        maxAgeMs,
        newStillMs);
  }

  long maxDelayNs() {
    return maxDelayMs * NS_PER_MS;
  }

  long maxLatencyNs() {
    return maxLatencyMs * NS_PER_MS;
  }

  long maxAgeNs() {
    return maxAgeMs * NS_PER_MS;
  }

  long stillNs() {
    return stillMs * NS_PER_MS;
  }

  /** A fix of a rigid body with this mean error of its markers. */
  Fix ofMarkers(Pose pose, double meanErrorMm, TimeSpan when) {
    double markersMm = errorScale * meanErrorMm;
    return fix(pose, markersMm, markersMm / markerSpreadMm, when);
  }

  /** A fix of a pose with these errors. */
  Fix fix(Pose pose, double errorMm, double errorRad, TimeSpan when) {
    double boundS = Time.seconds(when.boundNs());
    return new Fix(
        pose,
        when.middleNs(),
        Math.max(errorFloorMm, errorMm) + maxSpeedMmPerS * boundS,
        Math.min(StrictMath.PI, Math.max(errorFloorRad, errorRad) + maxTurnRadPerS * boundS));
  }

  private static void check(String name, double value, boolean mayBeZero) {
    if (!(value >= 0) || Double.isInfinite(value) || (value == 0 && !mayBeZero)) {
      throw new IllegalArgumentException(
          name + " is " + value + ": expected a number " + (mayBeZero ? "from 0 on" : "above 0"));
    }
  }

  private static void checkMs(String name, long value) {
    if (value < 0 || value > MS_PER_HOUR) {
      throw new IllegalArgumentException(
          name + " is " + value + ": expected from 0 to " + MS_PER_HOUR);
    }
  }
}

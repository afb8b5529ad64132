package org.starl.geometry;

/**
 * A measured pose of a robot.
 *
 * @param timeNs time of the measurement, on the robot's own clock
 * @param errorMm upper bound of the position error
 * @param errorRad upper bound of the heading error
 */
public record Fix(Pose pose, long timeNs, double errorMm, double errorRad) {}

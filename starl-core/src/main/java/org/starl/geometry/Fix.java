package org.starl.geometry;

/**
 * One measurement of a robot's pose.
 *
 * @param timeNs when the pose was true, on the robot's own clock
 * @param errorMm the true position lay within this distance of the measured one
 * @param errorRad the true heading lay within this angle of the measured one
 */
public record Fix(Pose pose, long timeNs, double errorMm, double errorRad) {}

package org.starl.robot.optitrack;

import org.starl.geometry.Pose;

/**
 * The content of one JSON line.
 *
 * @param robot its name
 * @param errorMm the true position lies within this distance
 * @param errorRad the true heading lies within this angle; 0 if not given
 * @param atNs time of measurement, on the sender's clock
 */
record JsonPose(String robot, Pose pose, double errorMm, double errorRad, long atNs) {}

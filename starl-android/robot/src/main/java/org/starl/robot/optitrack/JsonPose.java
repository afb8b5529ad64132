package org.starl.robot.optitrack;

import org.starl.geometry.Pose;

/**
 * What one JSON line says.
 *
 * @param robot its name
 * @param errorMm the true position lies within this distance
 * @param errorRad the true heading lies within this angle; 0 if the line does not say
 * @param atNs when it was measured, on the sender's clock
 */
record JsonPose(String robot, Pose pose, double errorMm, double errorRad, long atNs) {}

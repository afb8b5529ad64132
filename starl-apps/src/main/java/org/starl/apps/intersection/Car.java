package org.starl.apps.intersection;

import org.starl.apps.intersection.logic.Trip;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * A car of a scenario.
 *
 * @param lane cars of one lane come onto the floor one after another
 * @param start where it comes onto the floor
 * @param readyNs not before this time
 */
record Car(RobotId id, String lane, Pose start, Trip trip, long readyNs) {}

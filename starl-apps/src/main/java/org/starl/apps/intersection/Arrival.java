package org.starl.apps.intersection;

import org.starl.apps.intersection.logic.Route;
import org.starl.id.RobotId;

/** A car that comes to the edge of an open road, at {@code atNs}, to go along {@code route}. */
record Arrival(RobotId id, Route route, long atNs) {}

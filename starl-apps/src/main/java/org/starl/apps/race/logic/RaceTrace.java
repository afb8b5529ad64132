package org.starl.apps.race.logic;

import org.starl.GlobalVarHolder;

/** How one robot in a race appears in a trace. */
public final class RaceTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link RaceApp.Location}. */
  public static final String LOCATION = "location";

  /** Variable: the name of the point that the robot races to; empty if there is none. */
  public static final String POINT = "point";

  /**
   * Action with a point's place and name, this robot's distance from it in mm, that distance's error
   * bound, and the mm from which it may be won.
   */
  public static final String ARRIVE = "arrive";

  private RaceTrace() {}

  static void arrive(GlobalVarHolder gvh, int place, RacePoint point, int keptOffMm) {
    gvh.trace.action(
        SOURCE,
        ARRIVE,
        place,
        point.name(),
        gvh.gps.pose().distanceMm(point.at()),
        gvh.gps.errorMm(),
        Math.max(point.radiusMm(), keptOffMm));
  }
}

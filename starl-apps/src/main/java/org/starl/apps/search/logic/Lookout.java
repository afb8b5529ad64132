package org.starl.apps.search.logic;

import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;

/** Reads the sensor; the first thing that it shows is the end of the search. Strand only. */
final class Lookout {

  private final GlobalVarHolder gvh;
  private final Sensing sensing;
  private final Team team;

  Lookout(GlobalVarHolder gvh, Sensing sensing, Team team) {
    this.gvh = gvh;
    this.sensing = sensing;
    this.team = team;
  }

  /** What it shows is seen from where the robot is now: of a robot that does not know, nothing is. */
  void look() {
    if (!gvh.gps.hasFix()) {
      return;
    }
    for (ItemPosition thing : sensing.sensed()) {
      if (team.answer().isEmpty()) {
        Point at = thing.at();
        int xMm = (int) Math.round(at.xMm());
        int yMm = (int) Math.round(at.yMm());
        gvh.trace.action(SearchTrace.SOURCE, SearchTrace.FOUND, thing.name(), xMm, yMm);
        team.conclude(new Answer.Found(thing.name(), xMm, yMm, gvh.id.name().name()));
      }
    }
  }
}

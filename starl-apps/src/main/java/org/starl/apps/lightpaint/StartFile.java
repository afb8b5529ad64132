package org.starl.apps.lightpaint;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/** Reads where painters start: a waypoint file, a line for each. */
final class StartFile {

  private StartFile() {}

  /**
   * The first places of the file, one for each painter.
   *
   * @param radiusMm half the width of a tube: each painter needs a disc of that size
   */
  static List<Point> read(Path file, int painters, double radiusMm) {
    List<Waypoint> starts = WaypointFiles.read(file).waypoints();
    if (starts.size() < painters) {
      throw new BadInput(
          file
              + ": "
              + starts.size()
              + " starts: expected one for each of "
              + painters
              + " painters");
    }
    List<Point> points = new ArrayList<>();
    for (Waypoint start : starts.subList(0, painters)) {
      Point at = new Point(start.xMm(), start.yMm());
      for (int i = 0; i < points.size(); i++) {
        if (points.get(i).distanceMm(at) < 2 * radiusMm + 2) {
          throw new BadInput(
              file
                  + ": "
                  + starts.get(i).name()
                  + " and "
                  + start.name()
                  + " are "
                  + Math.round(points.get(i).distanceMm(at))
                  + " mm apart: expected at least "
                  + Math.round(2 * radiusMm + 2));
        }
      }
      points.add(at);
    }
    return points;
  }
}

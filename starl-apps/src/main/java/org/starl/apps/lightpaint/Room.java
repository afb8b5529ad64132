package org.starl.apps.lightpaint;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * The floor of a drawing: the drawing's bounding box and a margin around it, in which every painter
 * has a home. The homes are evenly spread.
 *
 * @param floor all bodies stay inside
 * @param homes one for each painter; a painter there is in the way of no tube along the drawing
 */
record Room(Rectangle floor, List<Point> homes) {

  private static final double SPARE_MM = 30;

  Room {
    homes = List.copyOf(homes);
  }

  /**
   * @param starts where painters start, if not at home: on the floor as well
   * @param radiusMm half the width of a tube
   */
  static Room around(List<Stroke> strokes, List<Point> starts, int painters, double radiusMm) {
    List<Point> points = new ArrayList<>(starts);
    strokes.forEach(stroke -> points.addAll(stroke.path().points()));
    Rectangle drawing = Rectangle.around(points);
    // A tube may run along the border of the drawing while other painters are at home.
    double apartMm = 2 * radiusMm + SPARE_MM;
    double marginMm = apartMm;
    while (ring(drawing.widened(marginMm)).lengthMm() < painters * apartMm) {
      marginMm += apartMm;
    }
    Polyline ring = ring(drawing.widened(marginMm));
    List<Point> homes = new ArrayList<>();
    for (int i = 0; i < painters; i++) {
      homes.add(Polyline.rounded(ring.at(ring.lengthMm() / painters * (i + 0.5))));
    }
    return new Room(drawing.widened(marginMm + radiusMm + SPARE_MM), homes);
  }

  /** The border, from the lower left corner counter-clockwise. */
  private static Polyline ring(Rectangle box) {
    Point start = new Point(box.xMinMm(), box.yMinMm());
    return new Polyline(
        List.of(
            start,
            new Point(box.xMaxMm(), box.yMinMm()),
            new Point(box.xMaxMm(), box.yMaxMm()),
            new Point(box.xMinMm(), box.yMaxMm()),
            start));
  }

  /**
   * The starts in a waypoint file, one line for each painter.
   *
   * @throws BadInput if there are fewer than painters, or two tubes at them would meet
   */
  static List<Point> readStarts(Path file, int painters, double radiusMm) {
    List<Waypoint> starts = WaypointFiles.read(file).waypoints();
    if (starts.size() < painters) {
      throw new BadInput(
          "%s: %d starts: expected one for each of %d painters"
              .formatted(file, starts.size(), painters));
    }
    double apartMm = 2 * radiusMm + 2;
    List<Point> points = new ArrayList<>();
    for (Waypoint start : starts.subList(0, painters)) {
      Point at = new Point(start.xMm(), start.yMm());
      for (int i = 0; i < points.size(); i++) {
        double mm = points.get(i).distanceMm(at);
        if (mm < apartMm) {
          throw new BadInput(
              "%s: %s and %s are %d mm apart: expected at least %d"
                  .formatted(
                      file,
                      starts.get(i).name(),
                      start.name(),
                      Math.round(mm),
                      Math.round(apartMm)));
        }
      }
      points.add(at);
    }
    return points;
  }
}

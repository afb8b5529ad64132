package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/** What a light painted from when it went on until it went off. */
public final class Pass {

  private final RobotId robot;
  private final int stroke;
  private final Ink ink;
  private final List<Point> points;

  /** The part of the stroke that {@link #cover} has marked, and its latest place. */
  private double fromMm;

  private double toMm;
  private double atMm;

  Pass(RobotId robot, int stroke, Ink ink, List<Point> points) {
    this.robot = robot;
    this.stroke = stroke;
    this.ink = ink;
    this.points = new ArrayList<>(points);
  }

  public RobotId robot() {
    return robot;
  }

  /** The number of the stroke that the light names. */
  public int stroke() {
    return stroke;
  }

  public Ink ink() {
    return ink;
  }

  /** True positions of the light, one every 10 ms while it moves. */
  public List<Point> points() {
    return Collections.unmodifiableList(points);
  }

  void add(Point point) {
    points.add(point);
  }

  Point latest() {
    return points.get(points.size() - 1);
  }

  double fromMm() {
    return fromMm;
  }

  double toMm() {
    return toMm;
  }

  /**
   * Marks the part of the stroke to the latest point.
   *
   * @param reachMm maximum distance along the stroke between two points of a pass
   */
  void cover(Polyline path, double reachMm) {
    if (points.size() == 1) {
      atMm = path.nearestMm(latest(), 0, path.lengthMm());
      fromMm = atMm;
      toMm = atMm;
    } else {
      atMm = path.nearestMm(latest(), atMm - reachMm, atMm + reachMm);
      fromMm = Math.min(fromMm, atMm);
      toMm = Math.max(toMm, atMm);
    }
  }

  /** How far, in mm, the pass has come back over the part that it had painted. */
  double backMm() {
    return Math.min(toMm - atMm, atMm - fromMm);
  }
}

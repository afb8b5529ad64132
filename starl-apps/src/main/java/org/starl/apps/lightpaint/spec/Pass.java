package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/** What one light has painted from when it went on until it went off. */
public final class Pass {

  private final RobotId robot;
  private final int stroke;
  private final Ink ink;
  private final List<Point> points = new ArrayList<>();

  Pass(RobotId robot, int stroke, Ink ink) {
    this.robot = robot;
    this.stroke = stroke;
    this.ink = ink;
  }

  public RobotId robot() {
    return robot;
  }

  /** The number of the stroke that the painter says it paints. */
  public int stroke() {
    return stroke;
  }

  public Ink ink() {
    return ink;
  }

  /** Where the light truly was, every 10 ms of movement. */
  public List<Point> points() {
    return Collections.unmodifiableList(points);
  }

  Pass copy() {
    Pass copy = new Pass(robot, stroke, ink);
    copy.points.addAll(points);
    return copy;
  }

  void add(Point point) {
    points.add(point);
  }
}

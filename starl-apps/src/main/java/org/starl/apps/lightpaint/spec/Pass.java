package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/** What a light painted from when it went on until it went off. */
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

  public double lengthMm() {
    double sum = 0;
    for (int i = 1; i < points.size(); i++) {
      sum += points.get(i - 1).distanceMm(points.get(i));
    }
    return sum;
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

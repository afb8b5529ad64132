package org.starl.geometry;

/** A named pose on the floor: a waypoint, a start or a goal. */
public record ItemPosition(String name, Pose pose) {

  public ItemPosition(String name, double xMm, double yMm) {
    this(name, new Pose(xMm, yMm, 0));
  }

  public Point at() {
    return pose.at();
  }

  /** {@code goal@1000.0,0.0}: without the heading. */
  @Override
  public String toString() {
    return name + "@" + pose.xMm() + "," + pose.yMm();
  }
}

package org.starl.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Segment;
import org.starl.time.Time;

/** Finds the walls near a point: a fixed grid over the bounding box of all walls. */
final class WallGrid {

  /** Receives each wall of a query. */
  interface Visitor {
    void visit(Wall wall);
  }

  private static final double LEAST_CELL_MM = 500;
  private static final int MOST_CELLS_A_SIDE = 512;

  private final List<Wall> walls = new ArrayList<>();
  private final List<Solid> solids = new ArrayList<>();
  private double leastX = Double.POSITIVE_INFINITY;
  private double leastY = Double.POSITIVE_INFINITY;
  private double cellMm;
  private int columns;
  private int rows;
  private Wall[][] cells = new Wall[0][];
  private Solid[][] solidCells = new Solid[0][];
  private long query;

  WallGrid(Obstacles obstacles) {
    for (Obstacle obstacle : obstacles.all()) {
      long untilNs = untilNs(obstacle);
      for (Segment side : obstacle.sides()) {
        walls.add(
            new Wall(
                side.from().xMm(), side.from().yMm(), side.to().xMm(), side.to().yMm(), untilNs));
      }
      if (obstacle.closed()) {
        solids.add(new Solid(obstacle.points(), untilNs));
      }
    }
    if (!walls.isEmpty()) {
      layOut();
    }
  }

  /** The next time after {@code nowNs} at which a wall disappears, or {@link Body#NEVER}. */
  long nextEndNs(long nowNs) {
    long next = Body.NEVER;
    for (Wall wall : walls) {
      if (wall.untilNs > nowNs) {
        next = Math.min(next, wall.untilNs);
      }
    }
    return next;
  }

  /** Visits, once each, a superset of the present walls within {@code rangeMm} of a point. */
  void forEachNear(double xMm, double yMm, double rangeMm, long nowNs, Visitor visitor) {
    if (cells.length == 0) {
      return;
    }
    query++;
    int lastColumn = Math.min(columns - 1, index(xMm + rangeMm - leastX));
    int lastRow = Math.min(rows - 1, index(yMm + rangeMm - leastY));
    for (int row = Math.max(0, index(yMm - rangeMm - leastY)); row <= lastRow; row++) {
      for (int column = Math.max(0, index(xMm - rangeMm - leastX));
          column <= lastColumn;
          column++) {
        for (Wall wall : cells[row * columns + column]) {
          if (wall.seenBy != query && wall.standsAt(nowNs)) {
            wall.seenBy = query;
            visitor.visit(wall);
          }
        }
      }
    }
  }

  /** Whether a point is inside a present solid obstacle. */
  boolean isInside(Point point, long nowNs) {
    int column = cells.length == 0 ? -1 : index(point.xMm() - leastX);
    int row = cells.length == 0 ? -1 : index(point.yMm() - leastY);
    if (column < 0 || column >= columns || row < 0 || row >= rows) {
      return false;
    }
    for (Solid solid : solidCells[row * columns + column]) {
      if (nowNs < solid.untilNs && solid.polygon.contains(point)) {
        return true;
      }
    }
    return false;
  }

  private void layOut() {
    double mostX = Double.NEGATIVE_INFINITY;
    double mostY = Double.NEGATIVE_INFINITY;
    for (Wall wall : walls) {
      leastX = Math.min(leastX, wall.leastX());
      leastY = Math.min(leastY, wall.leastY());
      mostX = Math.max(mostX, wall.mostX());
      mostY = Math.max(mostY, wall.mostY());
    }
    double side = Math.max(mostX - leastX, mostY - leastY);
    cellMm = Math.max(LEAST_CELL_MM, side / MOST_CELLS_A_SIDE);
    columns = index(mostX - leastX) + 1;
    rows = index(mostY - leastY) + 1;
    List<List<Wall>> filling = new ArrayList<>();
    List<List<Solid>> solidFilling = new ArrayList<>();
    for (int i = 0; i < columns * rows; i++) {
      filling.add(new ArrayList<>(0));
      solidFilling.add(new ArrayList<>(0));
    }
    for (Wall wall : walls) {
      enter(wall, filling);
    }
    for (Solid solid : solids) {
      enter(solid, solidFilling);
    }
    cells = new Wall[columns * rows][];
    solidCells = new Solid[columns * rows][];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = filling.get(i).toArray(new Wall[0]);
      solidCells[i] = solidFilling.get(i).toArray(new Solid[0]);
    }
  }

  private void enter(Wall wall, List<List<Wall>> filling) {
    double halfDiagonalMm = cellMm * 0.7072;
    for (int row = index(wall.leastY() - leastY); row <= index(wall.mostY() - leastY); row++) {
      for (int column = index(wall.leastX() - leastX);
          column <= index(wall.mostX() - leastX);
          column++) {
        double centerX = leastX + (column + 0.5) * cellMm;
        double centerY = leastY + (row + 0.5) * cellMm;
        if (wall.distanceMm(centerX, centerY) <= halfDiagonalMm) {
          filling.get(row * columns + column).add(wall);
        }
      }
    }
  }

  private void enter(Solid solid, List<List<Solid>> filling) {
    for (int row = index(solid.leastY - leastY); row <= index(solid.mostY - leastY); row++) {
      for (int column = index(solid.leastX - leastX);
          column <= index(solid.mostX - leastX);
          column++) {
        filling.get(row * columns + column).add(solid);
      }
    }
  }

  private int index(double mm) {
    return (int) Math.floor(mm / cellMm);
  }

  private static long untilNs(Obstacle obstacle) {
    return obstacle.lifetimeMs() == Obstacle.FOREVER
        ? Body.NEVER
        : obstacle.lifetimeMs() * Time.NS_PER_MS;
  }

  /** A solid obstacle with its bounding box. */
  private static final class Solid {
    private final Polygon polygon;
    private final long untilNs;
    private double leastX = Double.POSITIVE_INFINITY;
    private double leastY = Double.POSITIVE_INFINITY;
    private double mostX = Double.NEGATIVE_INFINITY;
    private double mostY = Double.NEGATIVE_INFINITY;

    Solid(List<Point> corners, long untilNs) {
      this.polygon = new Polygon(corners);
      this.untilNs = untilNs;
      for (Point corner : corners) {
        leastX = Math.min(leastX, corner.xMm());
        leastY = Math.min(leastY, corner.yMm());
        mostX = Math.max(mostX, corner.xMm());
        mostY = Math.max(mostY, corner.yMm());
      }
    }
  }
}

package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.primitives.paths.Path;

/**
 * The floor in rectangles, the sections of the robots' mutex: 32 at most, as many as one may ask for.
 * A block is called by its column and row, {@code 0.0} being at the lower left.
 */
public record Blocks(Rectangle floor, int columns, int rows) {

  private static final int MOST = 32;
  private static final int WANTED = 20;
  private static final double LEAST_SIDE_MM = 2_000;

  public Blocks {
    if (columns < 1 || rows < 1 || columns * rows > MOST) {
      throw new IllegalArgumentException(columns + " by " + rows + " blocks: expected 1 to 32");
    }
  }

  /** About twenty squares, none smaller than 2 m. */
  public static Blocks of(Rectangle floor) {
    double width = floor.xMaxMm() - floor.xMinMm();
    double height = floor.yMaxMm() - floor.yMinMm();
    double side = Math.max(LEAST_SIDE_MM, StrictMath.sqrt(width * height / WANTED));
    while (count(width, side) * count(height, side) > MOST) {
      side *= 1.1;
    }
    return new Blocks(floor, (int) count(width, side), (int) count(height, side));
  }

  private static double count(double lengthMm, double sideMm) {
    return Math.max(1, StrictMath.ceil(lengthMm / sideMm));
  }

  public SortedSet<String> all() {
    SortedSet<String> all = new TreeSet<>();
    for (int i = 0; i < columns * rows; i++) {
      all.add(name(i));
    }
    return all;
  }

  /** Those that a disc of this radius touches on its way. */
  public SortedSet<String> along(Path path, double radiusMm) {
    SortedSet<String> along = new TreeSet<>();
    for (int i = 0; i < columns * rows; i++) {
      for (int leg = 0; leg < path.legs(); leg++) {
        if (distanceMm(rectangle(i), path.leg(leg)) <= radiusMm) {
          along.add(name(i));
          break;
        }
      }
    }
    return along;
  }

  /** Those that a disc touches. */
  public SortedSet<String> around(Point at, double radiusMm) {
    return along(new Path(List.of(at, at)), radiusMm);
  }

  /** Where the centre of a disc may not be that is to stay in {@code held}. */
  List<Polygon> outside(Collection<String> held, double radiusMm) {
    List<Polygon> outside = new ArrayList<>();
    for (int i = 0; i < columns * rows; i++) {
      if (!held.contains(name(i))) {
        Rectangle r = rectangle(i);
        outside.add(
            Polygon.of(
                new Point(r.xMinMm() - radiusMm, r.yMinMm() - radiusMm),
                new Point(r.xMaxMm() + radiusMm, r.yMinMm() - radiusMm),
                new Point(r.xMaxMm() + radiusMm, r.yMaxMm() + radiusMm),
                new Point(r.xMinMm() - radiusMm, r.yMaxMm() + radiusMm)));
      }
    }
    return outside;
  }

  /** The block of this name. */
  public Rectangle rectangle(String name) {
    for (int i = 0; i < columns * rows; i++) {
      if (name(i).equals(name)) {
        return rectangle(i);
      }
    }
    throw new IllegalArgumentException("no block " + name);
  }

  private String name(int index) {
    return index % columns + "." + index / columns;
  }

  private Rectangle rectangle(int index) {
    double width = (floor.xMaxMm() - floor.xMinMm()) / columns;
    double height = (floor.yMaxMm() - floor.yMinMm()) / rows;
    int column = index % columns;
    int row = index / columns;
    double x = floor.xMinMm() + column * width;
    double y = floor.yMinMm() + row * height;
    return new Rectangle(x, y, x + width, y + height);
  }

  private static double distanceMm(Rectangle r, Segment leg) {
    if (r.contains(leg.from()) || r.contains(leg.to())) {
      return 0;
    }
    Point a = new Point(r.xMinMm(), r.yMinMm());
    Point b = new Point(r.xMaxMm(), r.yMinMm());
    Point c = new Point(r.xMaxMm(), r.yMaxMm());
    Point d = new Point(r.xMinMm(), r.yMaxMm());
    double low = Math.min(leg.distanceMm(new Segment(a, b)), leg.distanceMm(new Segment(b, c)));
    double high = Math.min(leg.distanceMm(new Segment(c, d)), leg.distanceMm(new Segment(d, a)));
    return Math.min(low, high);
  }
}

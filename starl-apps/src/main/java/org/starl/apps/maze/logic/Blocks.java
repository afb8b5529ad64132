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
 * The floor cut into rectangles, which are the sections of the robots' mutex. There are at most 32, the
 * most that one request may name. A block's name is its column and row; {@code 0.0} is at the lower
 * left.
 *
 * <p>A robot requests more around a way than it later plans in, so after a bump it has room to plan
 * again in the blocks that it holds.
 */
public record Blocks(Rectangle floor, int columns, int rows) {

  private static final int MOST = 32;
  private static final int WANTED = 20;
  private static final double LEAST_SIDE_MM = 2_000;

  // A robot requests the blocks within this distance of its body on the way ...
  private static final double ASK_MM = 120;
  // ... and its body stays this far inside them on a way that it plans later.
  private static final double INSIDE_MM = 50;

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

  /** The blocks to request for a way of a body that stays within {@code reachMm} of it. */
  SortedSet<String> toRequest(Path way, double reachMm) {
    return along(way, reachMm + ASK_MM);
  }

  /** Where a new way may not lead if all within {@code reachMm} of it is to be in {@code held}. */
  List<Polygon> forbidden(Collection<String> held, double reachMm) {
    return outside(held, reachMm + INSIDE_MM);
  }

  /** The blocks of {@code held} that a body does not need while it stands at {@code at}. */
  SortedSet<String> spare(Collection<String> held, Point at, double bodyMm) {
    SortedSet<String> spare = new TreeSet<>(held);
    spare.removeAll(around(at, bodyMm + ASK_MM));
    return spare;
  }

  /** The blocks that a disc of this radius touches on its way. */
  SortedSet<String> along(Path path, double radiusMm) {
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

  /** The blocks that a disc touches. */
  SortedSet<String> around(Point at, double radiusMm) {
    return along(new Path(List.of(at, at)), radiusMm);
  }

  /** Where the centre of a disc may not be if the disc is to stay in {@code held}. */
  List<Polygon> outside(Collection<String> held, double radiusMm) {
    List<Polygon> outside = new ArrayList<>();
    for (int i = 0; i < columns * rows; i++) {
      if (!held.contains(name(i))) {
        outside.add(polygon(rectangle(i).widened(radiusMm)));
      }
    }
    return outside;
  }

  private String name(int index) {
    return index % columns + "." + index / columns;
  }

  private Rectangle rectangle(int index) {
    double width = (floor.xMaxMm() - floor.xMinMm()) / columns;
    double height = (floor.yMaxMm() - floor.yMinMm()) / rows;
    double x = floor.xMinMm() + index % columns * width;
    int row = index / columns;
    double y = floor.yMinMm() + row * height;
    return new Rectangle(x, y, x + width, y + height);
  }

  private static Polygon polygon(Rectangle r) {
    return Polygon.of(
        new Point(r.xMinMm(), r.yMinMm()),
        new Point(r.xMaxMm(), r.yMinMm()),
        new Point(r.xMaxMm(), r.yMaxMm()),
        new Point(r.xMinMm(), r.yMaxMm()));
  }

  private static double distanceMm(Rectangle block, Segment leg) {
    if (block.contains(leg.from()) || block.contains(leg.to())) {
      return 0;
    }
    Polygon outline = polygon(block);
    double leastMm = Double.POSITIVE_INFINITY;
    for (int side = 0; side < outline.vertices().size(); side++) {
      leastMm = Math.min(leastMm, leg.distanceMm(outline.side(side)));
    }
    return leastMm;
  }
}

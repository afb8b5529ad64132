package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.primitives.paths.Path;

/**
 * The floor cut into rectangles, which are the sections of the robots' mutex. There are at most 32,
 * the most that one request may name. A block's name is its column and row; {@code 0.0} is at the
 * lower left.
 *
 * <p>A robot requests more around a way than it later plans in, so after a bump it has room to plan
 * again in the blocks that it holds.
 *
 * @param byName all blocks, row by row
 */
public record Blocks(Map<String, Rectangle> byName) {

  private static final int MOST = 32;
  private static final int WANTED = 20;
  private static final double LEAST_SIDE_MM = 2_000;

  // A robot requests the blocks within this distance of its body on the way ...
  private static final double ASK_MM = 120;
  // ... and its body stays this far inside them on a way that it plans later.
  private static final double INSIDE_MM = 50;

  /** About twenty squares, none smaller than 2 m. */
  public static Blocks of(Rectangle floor) {
    double width = floor.xMaxMm() - floor.xMinMm();
    double height = floor.yMaxMm() - floor.yMinMm();
    double side = Math.max(LEAST_SIDE_MM, StrictMath.sqrt(width * height / WANTED));
    while (StrictMath.ceil(width / side) * StrictMath.ceil(height / side) > MOST) {
      side *= 1.1;
    }
    return of(floor, (int) StrictMath.ceil(width / side), (int) StrictMath.ceil(height / side));
  }

  static Blocks of(Rectangle floor, int columns, int rows) {
    double width = (floor.xMaxMm() - floor.xMinMm()) / columns;
    double height = (floor.yMaxMm() - floor.yMinMm()) / rows;
    Map<String, Rectangle> blocks = new LinkedHashMap<>();
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        double x = floor.xMinMm() + column * width;
        double y = floor.yMinMm() + row * height;
        blocks.put(column + "." + row, new Rectangle(x, y, x + width, y + height));
      }
    }
    return new Blocks(blocks);
  }

  public SortedSet<String> all() {
    return new TreeSet<>(byName.keySet());
  }

  /** The blocks to request for a way of a body that stays within {@code reachMm} of it. */
  SortedSet<String> toRequest(Path way, double reachMm) {
    return near(way, reachMm + ASK_MM);
  }

  private SortedSet<String> near(Path way, double reachMm) {
    SortedSet<String> blocks = new TreeSet<>();
    for (int leg = 0; leg < way.legs(); leg++) {
      Segment axis = way.leg(leg);
      byName.forEach((name, block) -> {
        if (distanceMm(block, axis) <= reachMm) {
          blocks.add(name);
        }
      });
    }
    return blocks;
  }

  /** The areas to avoid if a new way and {@code reachMm} around it are to be in {@code held}. */
  List<Polygon> forbidden(Collection<String> held, double reachMm) {
    List<Polygon> forbidden = new ArrayList<>();
    byName.forEach((name, block) -> {
      if (!held.contains(name)) {
        forbidden.add(block.widened(reachMm + INSIDE_MM).outline());
      }
    });
    return forbidden;
  }

  /** The blocks of {@code held} that a body does not need while it stands at {@code at}. */
  SortedSet<String> spare(Collection<String> held, Point at, double bodyMm) {
    SortedSet<String> spare = new TreeSet<>(held);
    spare.removeAll(toRequest(new Path(List.of(at, at)), bodyMm));
    return spare;
  }

  private static double distanceMm(Rectangle block, Segment leg) {
    if (block.contains(leg.from()) || block.contains(leg.to())) {
      return 0;
    }
    Polygon outline = block.outline();
    double leastMm = Double.POSITIVE_INFINITY;
    for (int side = 0; side < outline.vertices().size(); side++) {
      leastMm = Math.min(leastMm, leg.distanceMm(outline.side(side)));
    }
    return leastMm;
  }
}

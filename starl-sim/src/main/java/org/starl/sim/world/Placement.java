package org.starl.sim.world;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/** Draws free places for robots, in time that is linear in their number. */
public final class Placement {

  private static final int MAX_TRIES = 10_000;

  private final double widthMm;
  private final double heightMm;
  private final double radiusMm;
  private final double spacingMm;
  private final Obstacles obstacles;
  // Indexed by cell. Cells are so large that two places nearer than the spacing are in the same or
  // in adjacent cells. Used only for lookups, never iterated.
  private final Map<Long, List<Point>> cells = new HashMap<>();

  /**
   * Places lie on the floor from (0, 0) to (width, height).
   *
   * @param spacingMm the minimum distance between the centres of two robots
   */
  public Placement(
      double widthMm, double heightMm, double radiusMm, double spacingMm, Obstacles obstacles) {
    this.widthMm = widthMm;
    this.heightMm = heightMm;
    this.radiusMm = radiusMm;
    this.spacingMm = spacingMm;
    this.obstacles = obstacles;
  }

  /**
   * Draws {@code count} poses: the whole body on the floor, clear of obstacles and of the other
   * bodies, with uniform headings.
   *
   * @throws BadInput if there is not enough room
   */
  public List<Pose> draw(int count, Rng rng) {
    List<Pose> poses = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      poses.add(drawOne(count, rng));
    }
    return poses;
  }

  private Pose drawOne(int count, Rng rng) {
    for (int i = 0; i < MAX_TRIES; i++) {
      Point at =
          new Point(
              radiusMm + rng.nextDouble() * (widthMm - 2 * radiusMm),
              radiusMm + rng.nextDouble() * (heightMm - 2 * radiusMm));
      if (isFree(at)) {
        cells.computeIfAbsent(cell(at, 0, 0), key -> new ArrayList<>()).add(at);
        return Pose.of(at, (2 * rng.nextDouble() - 1) * StrictMath.PI);
      }
    }
    throw new BadInput(
        "robots: "
            + count
            + ": expected fewer, or a larger floor than "
            + Math.round(widthMm)
            + " by "
            + Math.round(heightMm)
            + " mm (floorWidth, floorHeight)");
  }

  private boolean isFree(Point at) {
    for (int dx = -1; dx <= 1; dx++) {
      for (int dy = -1; dy <= 1; dy++) {
        for (Point other : cells.getOrDefault(cell(at, dx, dy), List.of())) {
          if (other.distanceMm(at) < spacingMm) {
            return false;
          }
        }
      }
    }
    return obstacles.distanceMm(at) > radiusMm;
  }

  private long cell(Point at, int dx, int dy) {
    long x = (long) StrictMath.floor(at.xMm() / spacingMm) + dx;
    long y = (long) StrictMath.floor(at.yMm() / spacingMm) + dy;
    return x << 32 ^ (y & 0xFFFFFFFFL);
  }
}

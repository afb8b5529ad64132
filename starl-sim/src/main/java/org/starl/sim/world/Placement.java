package org.starl.sim.world;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
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
   * @param taken places of other robots
   */
  public Placement(
      double widthMm,
      double heightMm,
      double radiusMm,
      double spacingMm,
      Obstacles obstacles,
      List<Point> taken) {
    this.widthMm = widthMm;
    this.heightMm = heightMm;
    this.radiusMm = radiusMm;
    this.spacingMm = spacingMm;
    this.obstacles = obstacles;
    taken.forEach(this::take);
  }

  /**
   * Draws {@code count} poses: the whole body on the floor, clear of obstacles and of the other
   * bodies, with uniform headings.
   *
   * @throws BadInput if there is not enough room
   */
  public List<Pose> draw(int count, Rng rng) {
    if (count > 0) {
      requireRoomForOne("floorWidth", widthMm);
      requireRoomForOne("floorHeight", heightMm);
    }
    List<Pose> poses = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      poses.add(drawOne(count, i, rng));
    }
    return poses;
  }

  private void requireRoomForOne(String key, double mm) {
    if (mm < 2 * radiusMm) {
      throw new BadInput(
          "%s=%s: expected at least %s, twice robotRadius"
              .formatted(key, Quantities.distanceText(mm), Quantities.distanceText(2 * radiusMm)));
    }
  }

  private void take(Point at) {
    cells.computeIfAbsent(cell(at, 0, 0), key -> new ArrayList<>()).add(at);
  }

  private Pose drawOne(int count, int before, Rng rng) {
    for (int i = 0; i < MAX_TRIES; i++) {
      Point at =
          new Point(
              radiusMm + rng.nextDouble() * (widthMm - 2 * radiusMm),
              radiusMm + rng.nextDouble() * (heightMm - 2 * radiusMm));
      if (isFree(at)) {
        take(at);
        return Pose.of(at, (2 * rng.nextDouble() - 1) * StrictMath.PI);
      }
    }
    throw new BadInput(
        ("robots: %d: only %d found places %.0f mm apart on a floor of %.0f by %.0f mm:"
                + " expected fewer, or a larger floor (floorWidth, floorHeight)")
            .formatted(count, before, spacingMm, widthMm, heightMm));
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

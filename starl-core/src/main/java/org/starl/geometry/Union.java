package org.starl.geometry;

import java.util.List;

/**
 * The union of its parts.
 *
 * @param parts at least one; an empty region is {@link Nowhere}
 */
public record Union(List<Region> parts) implements Region {

  public Union {
    parts = List.copyOf(parts);
    if (parts.isEmpty()) {
      throw new IllegalArgumentException("union of no parts: expected at least one, or Nowhere");
    }
  }

  public static Union of(Region... parts) {
    return new Union(List.of(parts));
  }

  @Override
  public boolean contains(Point point) {
    for (int i = 0; i < parts.size(); i++) {
      if (parts.get(i).contains(point)) {
        return true;
      }
    }
    return false;
  }

  @Override
  public double distanceMm(Point point) {
    double best = Double.POSITIVE_INFINITY;
    for (int i = 0; i < parts.size(); i++) {
      best = Math.min(best, parts.get(i).distanceMm(point));
    }
    return best;
  }

  @Override
  public double depthMm(Point point) {
    double best = 0;
    for (int i = 0; i < parts.size(); i++) {
      best = Math.max(best, parts.get(i).depthMm(point));
    }
    return best;
  }

  /** For people: a long one is shortened. {@link RegionText#format} has all of it. */
  @Override
  public String toString() {
    return RegionText.brief(this);
  }
}

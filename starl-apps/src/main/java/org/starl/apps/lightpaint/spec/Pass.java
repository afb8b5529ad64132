package org.starl.apps.lightpaint.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/**
 * What a light painted from when it went on until it went off.
 *
 * <p>Which part of its stroke that was is not always certain: where the stroke comes near to itself
 * or crosses itself, a point is near to several places of it. So a pass keeps every reading of its
 * points as a movement along the stroke.
 */
public final class Pass {

  /**
   * A reading of the points so far.
   *
   * @param fromMm to {@code toMm}: the part of the stroke that was painted
   * @param atMm the place of the latest point
   * @param backMm how far, at most, the light came back over what it had painted
   * @param offMm the sum of the points' distances from their places
   */
  record Reading(double fromMm, double toMm, double atMm, double backMm, double offMm) {

    private Reading to(double nextMm, double distanceMm) {
      double low = Math.min(fromMm, nextMm);
      double high = Math.max(toMm, nextMm);
      double back = Math.max(backMm, Math.min(high - nextMm, nextMm - low));
      return new Reading(low, high, nextMm, back, offMm + distanceMm);
    }

    /**
     * First the readings in which nothing was painted twice, of these the nearest to the stroke.
     *
     * @param twiceMm the length of what was painted twice; up to the tolerance it counts as 0
     */
    static Comparator<Reading> likeliest(double toleranceMm, ToDoubleFunction<Reading> twiceMm) {
      return Comparator.comparingDouble(
              (Reading reading) -> {
                double mm = twiceMm.applyAsDouble(reading);
                return mm > toleranceMm ? mm : 0;
              })
          .thenComparingDouble(Reading::offMm);
    }

    /** The length, in mm, of what both painted. */
    double commonMm(Reading other) {
      return Math.min(toMm, other.toMm) - Math.max(fromMm, other.fromMm);
    }
  }

  private final RobotId robot;
  private final int stroke;
  private final Ink ink;
  private final List<Point> points;

  private List<Reading> readings = List.of();

  Pass(RobotId robot, int stroke, Ink ink, List<Point> points) {
    this.robot = robot;
    this.stroke = stroke;
    this.ink = ink;
    this.points = new ArrayList<>(points);
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

  void add(Point point) {
    points.add(point);
  }

  Point latest() {
    return points.get(points.size() - 1);
  }

  /** All readings of the points so far; empty if none is near to the stroke. */
  List<Reading> readings() {
    return readings;
  }

  /**
   * Reads the latest point: it is at one of its feet on the stroke.
   *
   * @param toleranceMm maximum distance of a light from its place; between two points it moves at
   *     most twice that far along the stroke, farther only over what it has painted
   */
  void read(Polyline path, double toleranceMm) {
    List<Reading> next = new ArrayList<>();
    for (double footMm : path.feetMm(latest(), toleranceMm)) {
      double distanceMm = path.at(footMm).distanceMm(latest());
      if (readings.isEmpty()) {
        next.add(new Reading(footMm, footMm, footMm, 0, distanceMm));
        continue;
      }
      readings.stream()
          .filter(reading -> footMm >= reading.fromMm() - 2 * toleranceMm)
          .filter(reading -> footMm <= reading.toMm() + 2 * toleranceMm)
          .map(reading -> reading.to(footMm, distanceMm))
          .min(Reading.likeliest(toleranceMm, Reading::backMm))
          .ifPresent(next::add);
    }
    if (!next.isEmpty()) {
      readings = List.copyOf(next);
    }
  }
}

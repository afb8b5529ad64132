package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * Where a car drives that does not stop at each station: straight on, and through its turn in an arc. All
 * lengths in mm.
 */
final class Track {

  /** Radius of the widest arc. It begins and ends at the edges of a zone. */
  private static final double ARC_MM = Crossing.LANE_MM / 2;

  /** So much before this it begins: a car drives 12.5 mm in its period. */
  private static final double EARLY_MM = 30;

  /** An arc that begins later is narrower. A body at full speed turns in no narrower one than this. */
  private static final double LEAST_ARC_MM = 150;

  /** Between a body that waits and the section that it waits for: more than its error bound. */
  private static final double GAP_MM = 25;

  private final List<String> sections = new ArrayList<>();
  private final List<Rectangle> regions = new ArrayList<>();
  private final List<Point> stops = new ArrayList<>();
  private final List<Boolean> corners = new ArrayList<>();
  private final Point exit;
  private final int turn;
  private final Point out;

  Track(Trip trip, double bodyMm) {
    List<ItemPosition> all = new ArrayList<>(trip.approach());
    all.addAll(trip.stations());
    exit = trip.exit().at();
    Route route = trip.route().orElse(null);
    int first = trip.approach().size();
    turn = route == null ? -1 : first + turn(route);
    for (int i = 0; i < all.size(); i++) {
      ItemPosition station = all.get(i);
      sections.add(station.name());
      regions.add(Crossing.region(station.name()));
      corners.add(route == null || i == turn);
      if (route == null || i == turn) {
        stops.add(station.at());
      } else {
        Point ahead = i < turn || turn < first ? inward(route) : route.lastZone().outward();
        stops.add(Crossing.frontStop(station.name(), ahead, bodyMm, GAP_MM));
      }
    }
    out = route == null ? new Point(0, 0) : route.lastZone().outward();
  }

  private static Point inward(Route route) {
    return route.from().arrivalSide().times(-1);
  }

  /** The zone in which it turns, by its number among the zones; far below 0 if it goes straight on. */
  private static int turn(Route route) {
    return switch (route.turn()) {
      case RIGHT -> 0;
      case STRAIGHT -> Integer.MIN_VALUE / 2;
      case LEFT -> 1;
    };
  }

  /** The places and zones, in order. */
  List<String> sections() {
    return sections;
  }

  Rectangle region(int index) {
    return regions.get(index);
  }

  /** Where a car waits that may enter no section after {@code index}; the exit after the last one. */
  Point stop(int index) {
    return index == sections.size() - 1 ? exit : stops.get(index);
  }

  /** The first corner from {@code index} on; the number of sections if there is none. */
  int corner(int index) {
    int i = index;
    while (i < sections.size() && !corners.get(i)) {
      i++;
    }
    return i;
  }

  /** The end of the arc through the turn that begins at {@code at}; null if there is none. */
  @Nullable Point arcEnd(Point at) {
    double awayMm = turn < 0 ? 0 : at.distanceMm(stops.get(turn));
    return awayMm < LEAST_ARC_MM || awayMm > ARC_MM + EARLY_MM
        ? null
        : stops.get(turn).plus(out.times(Math.min(awayMm, ARC_MM)));
  }

  /** Whether {@code at} is nearer to the exit than the whole body is to the last section. */
  boolean isBeyond(Point at, double bodyMm) {
    Point last = regions.get(regions.size() - 1).center();
    return at.minus(last).dot(out) > bodyMm || at.distanceMm(exit) < bodyMm;
  }
}

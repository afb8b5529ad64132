package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;

/**
 * Where a car drives that does not stop at each station: straight on, and through its turn in an arc. All
 * lengths in mm.
 */
final class Track {

  /** Radius of the arc. It begins and ends at the edges of a zone. */
  private static final double ARC_MM = Crossing.LANE_MM / 2;

  /** Between a body that waits and the section that it waits for: more than its error bound. */
  private static final double GAP_MM = 25;

  private final List<String> sections = new ArrayList<>();
  private final List<Point> stops = new ArrayList<>();
  private final List<Boolean> corners = new ArrayList<>();
  private final Point exit;
  private final @Nullable Arc arc;
  private final Point out;

  /** A turn: where it begins, and where it ends. */
  record Arc(Point from, Point to) {}

  Track(Trip trip, double bodyMm) {
    List<ItemPosition> all = new ArrayList<>(trip.approach());
    all.addAll(trip.stations());
    exit = trip.exit().at();
    Route route = trip.route().orElse(null);
    int first = trip.approach().size();
    int turn = route == null ? -1 : first + turn(route);
    for (int i = 0; i < all.size(); i++) {
      ItemPosition station = all.get(i);
      sections.add(station.name());
      corners.add(route == null || i == turn);
      if (route == null || i == turn) {
        stops.add(station.at());
      } else {
        Point ahead = i < turn || turn < first ? inward(route) : route.lastZone().outward();
        stops.add(Crossing.frontStop(station.name(), ahead, bodyMm, GAP_MM));
      }
    }
    out = route == null ? new Point(0, 0) : route.lastZone().outward();
    if (route == null || turn < first) {
      arc = null;
    } else {
      Point middle = stops.get(turn);
      Point from = middle.minus(inward(route).times(ARC_MM));
      arc = new Arc(from, middle.plus(out.times(ARC_MM)));
    }
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

  /** The number of the section of this name; -1 if there is none. */
  int indexOf(String section) {
    return sections.indexOf(section);
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

  /** The arc of the turn; null if there is none. */
  @Nullable Arc arc() {
    return arc;
  }

  /** Whether {@code at} is nearer to the exit than the whole body is to the last section. */
  boolean isBeyond(Point at, double bodyMm) {
    Point last = Crossing.region(sections.get(sections.size() - 1)).center();
    return at.minus(last).dot(out) > bodyMm || at.distanceMm(exit) < bodyMm;
  }
}

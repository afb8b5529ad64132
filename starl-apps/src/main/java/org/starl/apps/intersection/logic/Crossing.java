package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;

/**
 * The floor plan of Figure 2: a two by two square of critical zones, four arms of two lanes, with an
 * arrival zone {@code X0} and a departure zone {@code X1} at each zone {@code X}. In mm; x points
 * east, y north.
 *
 * @param middle where the four critical zones meet
 * @param zoneWidthMm width of a critical zone, and of a lane
 */
public record Crossing(Point middle, double zoneWidthMm) {

  /** Zones of 500 mm around (2500, 2500), where the original StarL's intersection lies. */
  public static final Crossing STANDARD = new Crossing(new Point(2500, 2500), 500);

  /**
   * Number of places of an arm on which cars queue: the arrival zone {@code X0} (rank 0), behind it
   * {@code X0.1}, and last {@code X0.2}, where cars enter an open road.
   */
  public static final int PLACES = 3;

  /** Number of places that cars claim: all but the last. */
  public static final int CLAIMED_PLACES = PLACES - 1;

  // Distances from the middle of the intersection along a lane, in zone widths. A car of 165 mm
  // radius
  // is clear of the critical zones at its arrival point and at its departure point, clear of its
  // departure zone at its exit, and clear of the places before and behind it in the middle of a
  // place.
  private static final double ARRIVAL_POINT = 1.6;
  private static final double PLACE_LENGTH = 1.2;
  private static final double DEPARTURE_POINT = 1.6;
  private static final double DEPARTURE_ZONE_END = 2.7;
  private static final double EXIT_POINT = 3.6;
  private static final double ROAD_END = 4.5;

  private static final double GOAL_RADIUS_MM = 10;

  /** Motion parameters of a car with the body of {@code body}. */
  public static MotionParameters motion(MotionParameters body) {
    return body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).build();
  }

  /** A critical zone's square. */
  public Rectangle region(Zone zone) {
    return Rectangle.around(centre(zone), zoneWidthMm, zoneWidthMm);
  }

  /** A zone or place by its name: {@code A}, {@code A1}, {@code A0}, {@code A0.1}. */
  public Rectangle region(String name) {
    Zone zone = Zone.valueOf(name.substring(0, 1));
    if (name.equals(zone.name())) {
      return region(zone);
    }
    if (name.equals(zone + "1")) {
      return lane(zone, zone.outward(), 1, DEPARTURE_ZONE_END);
    }
    for (int rank = 0; rank < PLACES; rank++) {
      if (name.equals(placeName(zone, rank))) {
        return place(zone, rank);
      }
    }
    throw new IllegalArgumentException("zone '" + name + "': expected such as A, A1, A0, A0.1");
  }

  /** Every zone that a car may hold, by name: critical zones and departure zones. */
  public SortedMap<String, Rectangle> regions() {
    SortedMap<String, Rectangle> regions = new TreeMap<>();
    for (Zone zone : Zone.values()) {
      regions.put(zone.name(), region(zone));
      regions.put(zone + "1", region(zone + "1"));
    }
    return regions;
  }

  /** The places of the given number of ranks, by name, the arrival zones first. */
  public SortedMap<String, Rectangle> places(int ranks) {
    SortedMap<String, Rectangle> places = new TreeMap<>();
    for (Zone zone : Zone.values()) {
      for (int rank = 0; rank < ranks; rank++) {
        places.put(placeName(zone, rank), place(zone, rank));
      }
    }
    return places;
  }

  /** The arrival zone {@code X0}, for rank 0, and the places behind it. */
  public Rectangle place(Zone zone, int rank) {
    double from = 1 + rank * PLACE_LENGTH;
    double to = 1 + (rank + 1) * PLACE_LENGTH;
    return lane(zone, zone.arrivalSide(), from, to);
  }

  /** {@code A0}, {@code A0.1}. */
  public static String placeName(Zone zone, int rank) {
    return rank == 0 ? zone + "0" : zone + "0." + rank;
  }

  /** The end of the road behind {@code X1}: a car that stops there leaves the floor. */
  public Rectangle exitRegion(Zone zone) {
    return lane(zone, zone.outward(), DEPARTURE_ZONE_END, ROAD_END);
  }

  /** The middle of a place, heading for the intersection. */
  public Pose placePose(Zone zone, int rank) {
    Point back = zone.arrivalSide();
    double widths = ARRIVAL_POINT + rank * PLACE_LENGTH;
    return Pose.of(along(zone, back, widths), back.times(-1).angleRad());
  }

  /** The trip of a car that enters the road at the last place of its arm. */
  public Trip tripFromEdge(Route route) {
    List<ItemPosition> approach = new ArrayList<>();
    for (int rank = CLAIMED_PLACES - 1; rank >= 0; rank--) {
      approach.add(station(placeName(route.from(), rank), placePose(route.from(), rank).at()));
    }
    Trip trip = trip(route);
    return new Trip(trip.label(), approach, trip.stations(), trip.exit());
  }

  /** The trip of a car that starts in the arrival zone: each zone's middle, departure point, exit. */
  public Trip trip(Route route) {
    List<ItemPosition> stations = new ArrayList<>();
    for (Zone zone : route.zones()) {
      stations.add(station(zone.name(), centre(zone)));
    }
    Zone last = route.lastZone();
    String departure = route.departure();
    stations.add(station(departure, along(last, last.outward(), DEPARTURE_POINT)));
    ItemPosition exit = station(departure + "-exit", along(last, last.outward(), EXIT_POINT));
    return new Trip(route.toString(), List.of(), stations, exit);
  }

  /** The middle of a critical zone. */
  public Point centre(Zone zone) {
    return middle.plus(zone.fromMiddle().times(zoneWidthMm));
  }

  /** The point of {@code zone}'s lane in {@code direction}, so many widths from the middle. */
  private Point along(Zone zone, Point direction, double widths) {
    Point centre = centre(zone);
    double alreadyMm = centre.minus(middle).dot(direction);
    return centre.plus(direction.times(widths * zoneWidthMm - alreadyMm));
  }

  private Rectangle lane(Zone zone, Point direction, double fromWidths, double toWidths) {
    Point across = new Point(direction.yMm(), direction.xMm()).times(zoneWidthMm / 2);
    Point from = along(zone, direction, fromWidths);
    Point to = along(zone, direction, toWidths);
    return Rectangle.around(List.of(from.plus(across), to.minus(across)));
  }

  private static ItemPosition station(String name, Point at) {
    return new ItemPosition(name, at.xMm(), at.yMm());
  }
}

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
import org.starl.geometry.Region;

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
   * On an arm cars queue on so many places: its arrival zone {@code X0}, behind it {@code X0.1}, and
   * last {@code X0.2}, where they come onto the road.
   */
  public static final int PLACES = 3;

  // From the middle of the intersection along a lane, in zone widths. A car of 165 mm radius that
  // waits at its arrival point or has reached its departure point is clear of the critical zones;
  // one that has reached its exit is clear of its departure zone;
  // one in the middle of a place is clear of the places before and behind it.
  private static final double ARRIVAL_POINT = 1.6;
  private static final double PLACE_LENGTH = 1.2;
  private static final double DEPARTURE_POINT = 1.6;
  private static final double DEPARTURE_ZONE_END = 2.7;
  private static final double EXIT_POINT = 3.6;
  private static final double ROAD_END = 4.5;

  private static final double GOAL_RADIUS_MM = 10;

  /** How cars move whose bodies are like that. */
  public static MotionParameters motion(MotionParameters body) {
    return body.toBuilder().goalRadiusMm(GOAL_RADIUS_MM).build();
  }

  /** A critical zone's square. */
  public Region region(Zone zone) {
    Point centre = centre(zone);
    double half = zoneWidthMm / 2;
    return new Rectangle(
        centre.xMm() - half, centre.yMm() - half, centre.xMm() + half, centre.yMm() + half);
  }

  /** A zone or place by its name: {@code A}, {@code A1}, {@code A0}, {@code A0.1}. */
  public Region region(String name) {
    Zone zone = Zone.valueOf(name.substring(0, 1));
    if (name.length() == 1) {
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

  /** Every zone that a car may hold, by name. */
  public SortedMap<String, Region> regions() {
    SortedMap<String, Region> regions = new TreeMap<>();
    for (Zone zone : Zone.values()) {
      regions.put(zone.name(), region(zone));
      regions.put(zone + "1", region(zone + "1"));
    }
    return regions;
  }

  /** Every place of an arm that a queueing car may hold, by name: all but the last one. */
  public SortedMap<String, Region> heldPlaces() {
    SortedMap<String, Region> places = new TreeMap<>();
    for (Zone zone : Zone.values()) {
      for (int rank = 0; rank < PLACES - 1; rank++) {
        places.put(placeName(zone, rank), place(zone, rank));
      }
    }
    return places;
  }

  /** The arrival zone {@code X0}, for rank 0, and the places behind it. */
  public Region place(Zone zone, int rank) {
    double from = 1 + rank * PLACE_LENGTH;
    double to = 1 + (rank + 1) * PLACE_LENGTH;
    return lane(zone, zone.arrivalSide(), from, to);
  }

  /** {@code A0}, {@code A0.1}. */
  public static String placeName(Zone zone, int rank) {
    return rank == 0 ? zone + "0" : zone + "0." + rank;
  }

  /** The end of the road behind {@code X1}: a car that stops there leaves the floor. */
  public Region exitRegion(Zone zone) {
    return lane(zone, zone.outward(), DEPARTURE_ZONE_END, ROAD_END);
  }

  /** Where a car waits for its zones, heading for the intersection. */
  public Pose arrivalPose(Zone zone) {
    return placePose(zone, 0);
  }

  /** The middle of a place, heading for the intersection. */
  public Pose placePose(Zone zone, int rank) {
    Point back = zone.arrivalSide();
    double widths = ARRIVAL_POINT + rank * PLACE_LENGTH;
    return Pose.of(along(zone, back, widths), back.times(-1).angleRad());
  }

  /** The trip of a car that comes onto the road at the last place of its arm. */
  public Trip tripFromEdge(Route route) {
    List<ItemPosition> approach = new ArrayList<>();
    for (int rank = PLACES - 2; rank >= 0; rank--) {
      approach.add(station(placeName(route.from(), rank), placePose(route.from(), rank).at()));
    }
    Trip trip = trip(route);
    return new Trip(trip.label(), approach, trip.stations(), trip.exit());
  }

  /** A car's trip along one of the twelve routes: each zone's middle, departure point, exit. */
  public Trip trip(Route route) {
    List<ItemPosition> stations = new ArrayList<>();
    for (Zone zone : route.zones()) {
      stations.add(station(zone.name(), centre(zone)));
    }
    Zone last = route.lastZone();
    Point out = last.outward();
    String departure = route.departure();
    stations.add(station(departure, along(last, out, DEPARTURE_POINT)));
    ItemPosition exit = station(departure + "-exit", along(last, out, EXIT_POINT));
    return new Trip(route.toString(), stations, exit);
  }

  /** The middle of a critical zone. */
  public Point centre(Zone zone) {
    return middle.plus(zone.fromMiddle().times(zoneWidthMm));
  }

  /** The point of {@code zone}'s lane in {@code direction}, that many widths from the middle. */
  private Point along(Zone zone, Point direction, double widths) {
    Point centre = centre(zone);
    double alreadyMm = centre.minus(middle).dot(direction);
    return centre.plus(direction.times(widths * zoneWidthMm - alreadyMm));
  }

  private Region lane(Zone zone, Point direction, double fromWidths, double toWidths) {
    Point a = along(zone, direction, fromWidths);
    Point b = along(zone, direction, toWidths);
    double half = zoneWidthMm / 2;
    double acrossX = direction.xMm() == 0 ? half : 0;
    double acrossY = direction.yMm() == 0 ? half : 0;
    return new Rectangle(
        Math.min(a.xMm(), b.xMm()) - acrossX,
        Math.min(a.yMm(), b.yMm()) - acrossY,
        Math.max(a.xMm(), b.xMm()) + acrossX,
        Math.max(a.yMm(), b.yMm()) + acrossY);
  }

  private static ItemPosition station(String name, Point at) {
    return new ItemPosition(name, at.xMm(), at.yMm());
  }
}

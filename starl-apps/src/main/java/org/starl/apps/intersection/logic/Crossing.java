package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.GlobalVarHolder;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;

/**
 * The floor plan of Figure 2: a two by two square of critical zones, four arms of two lanes, with an
 * arrival zone {@code X0} and a departure zone {@code X1} at each zone {@code X}. x points east, y
 * north.
 */
public final class Crossing {

  /**
   * Number of places of an arm on which cars queue: the arrival zone {@code X0} (rank 0), behind it
   * {@code X0.1}, and last {@code X0.2}, where cars enter an open road.
   */
  public static final int PLACES = 3;

  /** Number of places that cars claim: all but the last. */
  public static final int CLAIMED_PLACES = PLACES - 1;

  // Distances from the middle of the intersection along a lane, in zone widths. A car of 165 mm
  // radius is clear of the critical zones at its arrival point and at its departure point, clear of
  // its departure zone at its exit, and clear of the places before and behind it in the middle of a
  // place.
  private static final double ARRIVAL_POINT = 1.6;
  private static final double PLACE_LENGTH = 1.2;
  private static final double DEPARTURE_POINT = 1.6;
  private static final double DEPARTURE_ZONE_END = 2.7;
  private static final double EXIT_POINT = 3.6;
  private static final double ROAD_END = 4.5;

  private static final double GOAL_RADIUS_MM = 10;

  // A tenth of the speed, the slowest that is tried beside a region to avoid, for a reaction of 150
  // ms, and a millimetre for the arc.
  private static final double LEFT_MM = 6;

  // Where the original StarL's intersection lies.
  private static final Point MIDDLE = new Point(2500, 2500);

  /** Width of a lane, in mm. */
  public static final double LANE_MM = 500;

  /** Width of a critical zone. */
  private static final double ZONE_MM = LANE_MM;

  private static final SortedMap<String, Rectangle> REGIONS = regions(PLACES);

  private Crossing() {}

  /** Motion parameters of a car with the body of {@code body}: it backs off where it would stop. */
  public static MotionParameters motion(MotionParameters body) {
    boolean stops = body.collisionPolicy() == CollisionPolicy.STOP_ON_COLLISION;
    return body.toBuilder()
        .goalRadiusMm(GOAL_RADIUS_MM)
        .collisionPolicy(stops ? CollisionPolicy.USE_COLBACK : body.collisionPolicy())
        .build();
  }

  /**
   * The zones and places, except those in {@code own}, that the robot's body is certainly outside of:
   * it may not back into them.
   */
  static Region others(GlobalVarHolder gvh, Collection<String> own) {
    List<Region> others = new ArrayList<>();
    REGIONS.forEach((name, region) -> {
      if (!own.contains(name) && isClearOf(gvh, name, 0)) {
        others.add(region);
      }
    });
    return others.isEmpty() ? new Nowhere() : new Union(others);
  }

  /** The point so many zone widths east and north of the middle of the intersection. */
  public static Point at(double widthsEast, double widthsNorth) {
    return MIDDLE.plus(new Point(widthsEast, widthsNorth).times(ZONE_MM));
  }

  /** The middle of a critical zone. */
  public static Point centre(Zone zone) {
    return MIDDLE.plus(zone.fromMiddle().times(ZONE_MM));
  }

  /** A zone or place by its name: {@code A}, {@code A1}, {@code A0}, {@code A0.1}. */
  public static Rectangle region(String name) {
    Rectangle region = REGIONS.get(name);
    if (region == null) {
      throw new IllegalArgumentException("zone '" + name + "': expected such as A, A1, A0, A0.1");
    }
    return region;
  }

  /**
   * The zones and places that a car may hold, by name.
   *
   * @param ranks how many ranks of places: 0 for none, 1 for the arrival zones, {@link #PLACES} for all
   */
  public static SortedMap<String, Rectangle> regions(int ranks) {
    SortedMap<String, Rectangle> named = new TreeMap<>();
    for (Zone zone : Zone.values()) {
      named.put(zone.name(), Rectangle.around(centre(zone), ZONE_MM, ZONE_MM));
      named.put(zone + "1", lane(zone, zone.outward(), 1, DEPARTURE_ZONE_END));
      for (int rank = 0; rank < ranks; rank++) {
        double from = 1 + rank * PLACE_LENGTH;
        double to = 1 + (rank + 1) * PLACE_LENGTH;
        named.put(placeName(zone, rank), lane(zone, zone.arrivalSide(), from, to));
      }
    }
    return named;
  }

  /**
   * Whether the body of this robot is outside a zone or place for certain, and far enough to drive on
   * from there: beside a region to avoid, no command is safe that errors of the wheels could turn
   * towards it.
   */
  static boolean hasLeft(GlobalVarHolder gvh, String name) {
    return isClearOf(gvh, name, LEFT_MM);
  }

  private static boolean isClearOf(GlobalVarHolder gvh, String name, double byMm) {
    return gvh.gps.isClearOf(region(name), gvh.plat.moat.parameters().robotRadiusMm() + byMm);
  }

  /** The critical zone that contains {@code at}, if one does. */
  public static Optional<Zone> zoneAt(Point at) {
    return Arrays.stream(Zone.values())
        .filter(zone -> region(zone.name()).contains(at))
        .findFirst();
  }

  /** A place of an arm by its rank: {@code A0}, {@code A0.1}. */
  public static String placeName(Zone zone, int rank) {
    return rank == 0 ? zone + "0" : zone + "0." + rank;
  }

  /** The end of the road behind {@code X1}: a car that stops there leaves the floor. */
  public static Rectangle exitRegion(Zone zone) {
    return lane(zone, zone.outward(), DEPARTURE_ZONE_END, ROAD_END);
  }

  /** The middle of a place, heading for the intersection. */
  public static Pose placePose(Zone zone, int rank) {
    Point back = zone.arrivalSide();
    double widths = ARRIVAL_POINT + rank * PLACE_LENGTH;
    return Pose.of(along(zone, back, widths), back.times(-1).angleRad());
  }

  /**
   * The trip of a car that starts in the place of {@code rank} on its arm: the places ahead of it, each
   * zone's middle, the departure point, the exit.
   */
  public static Trip trip(Route route, int rank) {
    List<ItemPosition> approach = new ArrayList<>();
    for (int next = rank - 1; next >= 0; next--) {
      Point place = placePose(route.from(), next).at();
      approach.add(station(placeName(route.from(), next), place));
    }
    List<ItemPosition> stations = new ArrayList<>();
    for (Zone zone : route.zones()) {
      stations.add(station(zone.name(), centre(zone)));
    }
    Zone last = route.lastZone();
    String departure = route.departure();
    stations.add(station(departure, along(last, last.outward(), DEPARTURE_POINT)));
    ItemPosition exit = station(departure + "-exit", along(last, last.outward(), EXIT_POINT));
    return new Trip(route.toString(), Optional.of(route), approach, stations, exit);
  }

  /** The point of {@code zone}'s lane in {@code direction}, so many widths from the middle. */
  private static Point along(Zone zone, Point direction, double widths) {
    Point centre = centre(zone);
    double alreadyMm = centre.minus(MIDDLE).dot(direction);
    return centre.plus(direction.times(widths * ZONE_MM - alreadyMm));
  }

  private static Rectangle lane(Zone zone, Point direction, double fromWidths, double toWidths) {
    Point across = new Point(direction.yMm(), direction.xMm()).times(ZONE_MM / 2);
    Point from = along(zone, direction, fromWidths);
    Point to = along(zone, direction, toWidths);
    return Rectangle.around(List.of(from.plus(across), to.minus(across)));
  }

  /**
   * The way of a car's middle from the middle of the place of {@code rank} until its body has left its
   * departure zone, with an arc in its turn, in mm.
   */
  public static double wayMm(Route route, int rank, double bodyMm) {
    double arcMm = ZONE_MM / 2;
    double straightMm =
        ZONE_MM * (ARRIVAL_POINT + rank * PLACE_LENGTH + DEPARTURE_ZONE_END) + bodyMm;
    return switch (route.turn()) {
      case RIGHT -> straightMm - 2 * (ZONE_MM / 2 + arcMm) + StrictMath.PI / 2 * arcMm;
      case STRAIGHT -> straightMm;
      case LEFT -> straightMm + 2 * (ZONE_MM / 2 - arcMm) + StrictMath.PI / 2 * arcMm;
    };
  }

  /**
   * The point in {@code name} at which a body that heads for {@code ahead} has its front {@code gapMm}
   * before the end of that zone or place; not before its middle.
   *
   * @param ahead unit vector along an axis
   */
  static Point frontStop(String name, Point ahead, double bodyMm, double gapMm) {
    Rectangle region = region(name);
    Point middle = region.center();
    double halfMm =
        Math.abs(ahead.xMm()) * (region.xMaxMm() - region.xMinMm()) / 2
            + Math.abs(ahead.yMm()) * (region.yMaxMm() - region.yMinMm()) / 2;
    return middle.plus(ahead.times(Math.max(0, halfMm - bodyMm - gapMm)));
  }

  private static ItemPosition station(String name, Point at) {
    return new ItemPosition(name, at.xMm(), at.yMm());
  }
}

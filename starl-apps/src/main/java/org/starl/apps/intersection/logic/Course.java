package org.starl.apps.intersection.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;

/**
 * How far a car has come: the stations that still lie ahead, and the zones behind the car that it may
 * still be in. Strand only.
 */
final class Course {

  private final GlobalVarHolder gvh;
  private final Crossing crossing;
  private final Trip trip;
  private final CrossingTrace trace;
  private final ArrayDeque<ItemPosition> ahead;
  private final List<String> behind = new ArrayList<>();

  Course(GlobalVarHolder gvh, Crossing crossing, Trip trip, CrossingTrace trace) {
    this.gvh = gvh;
    this.crossing = crossing;
    this.trip = trip;
    this.trace = trace;
    ahead = new ArrayDeque<>(trip.stations());
  }

  /** Whether nothing lies ahead but the exit. */
  boolean isEmpty() {
    return ahead.isEmpty();
  }

  /** The zones ahead, in order. */
  List<String> zones() {
    return ahead.stream().map(Course::csName).collect(Collectors.toList());
  }

  /** The next station; after the last one, the exit. */
  ItemPosition currentDestination() {
    return ahead.isEmpty() ? trip.exit() : ahead.element();
  }

  /** The car is at the next station, and drives on: from now on that zone lies behind. */
  void remove() {
    behind.add(csName(ahead.remove()));
    trace.myseq(zones());
  }

  /** The zones behind that the whole body is out of for certain; each is told once. */
  List<String> left() {
    List<String> left = behind.stream().filter(this::isClearOf).collect(Collectors.toList());
    behind.removeAll(left);
    return left;
  }

  /** Whether the car is out of all zones behind, and has been told so. */
  boolean isAllLeft() {
    return behind.isEmpty();
  }

  /** The zones ahead that the body may be in. */
  List<String> occupied() {
    return zones().stream().filter(zone -> !isClearOf(zone)).collect(Collectors.toList());
  }

  /**
   * For a program that has started anew: finds out how far the car has come. What lies ahead is what
   * is left from the first zone it is in; nothing, if it is in none and nearer to the exit than to the
   * first station.
   *
   * @return whether it has reached the first zone, or is beyond all of them
   */
  boolean resume() {
    List<String> occupied = occupied();
    boolean isBeyond = occupied.isEmpty() && isNearerToTheExit();
    while (isBeyond ? !ahead.isEmpty() : isBehind(occupied)) {
      ahead.remove();
    }
    return isBeyond || !occupied.isEmpty();
  }

  /** Tells the trace what lies ahead, as the trip that is left. */
  void tell() {
    trace.trip(trip.label(), zones());
    trace.myseq(zones());
  }

  /** Whether the car is in some zones, and the next one of its trip is none of them. */
  private boolean isBehind(List<String> occupied) {
    return !occupied.isEmpty() && !occupied.contains(csName(ahead.element()));
  }

  private boolean isNearerToTheExit() {
    Point at = gvh.gps.pose().at();
    Point first = trip.stations().get(0).at();
    return at.distanceMm(trip.exit().at()) < at.distanceMm(first);
  }

  private boolean isClearOf(String zone) {
    double radiusMm = gvh.plat.moat.parameters().robotRadiusMm();
    return gvh.gps.isClearOf(crossing.region(zone), radiusMm);
  }

  private static String csName(ItemPosition station) {
    return station.name();
  }
}

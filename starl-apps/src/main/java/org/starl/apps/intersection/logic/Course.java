package org.starl.apps.intersection.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;

/**
 * The car's progress on its trip: the stations ahead, and the zones behind that the body may still be
 * in. Strand only.
 */
final class Course {

  private final GlobalVarHolder gvh;
  private final Trip trip;
  private final Consumer<List<String>> onChange;
  private final ArrayDeque<ItemPosition> ahead;
  private final List<String> behind = new ArrayList<>();

  /**
   * @param onChange is told the zones ahead when they change
   */
  Course(GlobalVarHolder gvh, Trip trip, Consumer<List<String>> onChange) {
    this.gvh = gvh;
    this.trip = trip;
    this.onChange = onChange;
    ahead = new ArrayDeque<>(trip.stations());
  }

  /** Whether only the exit lies ahead. */
  boolean isEmpty() {
    return ahead.isEmpty();
  }

  /** The zones ahead, in order. */
  List<String> zones() {
    return ahead.stream().map(ItemPosition::name).collect(Collectors.toList());
  }

  /** The next station; after the last one, the exit. */
  ItemPosition currentDestination() {
    return ahead.isEmpty() ? trip.exit() : ahead.element();
  }

  /** The car is at the next station and drives on: that zone is behind from now on. */
  void remove() {
    behind.add(ahead.remove().name());
    onChange.accept(zones());
  }

  /** The zones behind that the whole body has left for certain. */
  List<String> left() {
    List<String> left = new ArrayList<>(behind);
    left.removeIf(zone -> !Crossing.hasLeft(gvh, zone));
    return left;
  }

  /** Removes and returns the zones behind that the whole body has left for certain. */
  List<String> takeLeft() {
    List<String> left = left();
    behind.removeAll(left);
    return left;
  }

  /** Whether {@link #takeLeft} has returned all zones behind. */
  boolean isAllLeft() {
    return behind.isEmpty();
  }

  /** The zones ahead that the body may be in. */
  List<String> occupied() {
    List<String> occupied = zones();
    occupied.removeIf(zone -> Crossing.hasLeft(gvh, zone));
    return occupied;
  }

  /**
   * After a restart of the program: finds out how far the car has come. The rest of the trip starts at
   * the first zone that the body may be in. It is empty if the body is in no zone and nearer to the
   * exit than to the first station.
   *
   * @return whether the car has reached the first zone, or is beyond all zones
   */
  boolean resume() {
    List<String> occupied = occupied();
    Point at = gvh.gps.pose().at();
    Point first = trip.stations().get(0).at();
    boolean isBeyond = occupied.isEmpty() && at.distanceMm(trip.exit().at()) < at.distanceMm(first);
    if (isBeyond) {
      ahead.clear();
    }
    while (!occupied.isEmpty() && !occupied.contains(ahead.element().name())) {
      ahead.remove();
    }
    return isBeyond || !occupied.isEmpty();
  }

  /** Writes the rest of the trip to the trace. */
  void tell() {
    gvh.trace.action(Way.SHAPE, Way.of(trip, zones()));
    onChange.accept(zones());
  }
}

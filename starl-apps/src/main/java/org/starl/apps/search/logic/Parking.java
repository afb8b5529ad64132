package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;

/**
 * Drives a robot without a room out of the others' way: to a place deep inside the nearest room
 * that was searched, or, if it finds none, back to a start. A robot that stands at a start stays
 * there. Strand only.
 */
final class Parking {

  private static final long PATIENCE_MS = 10_000;
  private static final double SAME_MM = 300;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Drive drive;
  private final Predicate<Room> isSwept;
  private final List<Point> places = new ArrayList<>();
  private boolean isUnderWay;
  private boolean isParked;

  Parking(GlobalVarHolder gvh, House house, Drive drive, Predicate<Room> isSwept) {
    this.gvh = gvh;
    this.house = house;
    this.drive = drive;
    this.isSwept = isSwept;
  }

  /** The robot has no work from now on. */
  void begin() {
    places.clear();
    isUnderWay = false;
    isParked = false;
  }

  /** One step; to be called every period. */
  void step() {
    if (isParked || !gvh.gps.hasFix()) {
      return;
    }
    Drive.State state = isUnderWay ? drive.check() : Drive.State.BLOCKED;
    isParked = isUnderWay ? state == Drive.State.ARRIVED : isAtStart();
    if (!isParked && state == Drive.State.BLOCKED) {
      if (places.isEmpty()) {
        addPlaces();
      }
      isUnderWay = true;
      drive.to(places.remove(0), PATIENCE_MS);
    }
  }

  private boolean isAtStart() {
    return house.plan().starts().stream()
        .anyMatch(start -> gvh.gps.pose().distanceMm(start) < SAME_MM);
  }

  /**
   * Rooms that were searched, the nearest first; then starts, the one farthest from all rooms
   * first.
   */
  private void addPlaces() {
    Point here = gvh.gps.pose().at();
    int[] distances = house.distancesMm(here);
    int hereRoom = house.roomAt(here);
    house.rooms().stream()
        .filter(room -> room.isEnterable() && isSwept.test(room))
        .sorted(
            Comparator.comparingInt(room -> hereRoom == room.index() ? 0 : distances[room.index()]))
        .forEach(room -> places.add(room.rest()));
    places.addAll(
        house.plan().starts().stream()
            .sorted(
                Comparator.comparingInt(
                    start -> -Arrays.stream(house.distancesMm(start)).min().orElse(0)))
            .collect(Collectors.toList()));
  }
}

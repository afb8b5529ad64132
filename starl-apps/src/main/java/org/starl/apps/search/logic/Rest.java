package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;

/**
 * Where a robot goes that has nothing to do, so that it is in nobody's way: deep into the nearest
 * room that was searched, unless it stands where somebody started; if there is none, back to such a
 * place. Strand only.
 */
final class Rest {

  private static final long PATIENCE_MS = 10_000;
  private static final double SAME_MM = 300;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Drive drive;
  private final Predicate<Room> isSwept;
  private final List<Point> places = new ArrayList<>();
  private boolean underWay;
  private boolean resting;

  /**
   * @param isSwept whether nobody is to search a room any more
   */
  Rest(GlobalVarHolder gvh, House house, Drive drive, Predicate<Room> isSwept) {
    this.gvh = gvh;
    this.house = house;
    this.drive = drive;
    this.isSwept = isSwept;
  }

  /** It has nothing to do from now on. */
  void begin() {
    places.clear();
    underWay = false;
    resting = false;
  }

  /** One step; to be called every period. */
  void step() {
    if (resting || !gvh.gps.hasFix()) {
      return;
    }
    if (underWay) {
      switch (drive.look()) {
        case UNDER_WAY -> {
          return;
        }
        case THERE -> {
          resting = true;
          return;
        }
        case BLOCKED -> {
          // To the next room.
        }
      }
    } else if (isAtItsStart()) {
      resting = true;
      return;
    }
    if (places.isEmpty()) {
      addSweptRooms();
      addStarts();
    }
    underWay = true;
    drive.to(places.remove(0), PATIENCE_MS);
  }

  private boolean isAtItsStart() {
    for (Point start : house.plan().starts()) {
      if (gvh.gps.pose().distanceMm(start) < SAME_MM) {
        return true;
      }
    }
    return false;
  }

  /** Adds those that were searched, the nearest first. */
  private void addSweptRooms() {
    List<Room> rooms = new ArrayList<>();
    for (Room room : house.rooms()) {
      if (room.isEnterable() && isSwept.test(room)) {
        rooms.add(room);
      }
    }
    if (rooms.size() > 1) {
      Point here = gvh.gps.pose().at();
      int[] distances = house.distancesMm(here);
      rooms.sort(
          Comparator.comparingInt(
              room -> house.roomAt(here) == room.index() ? 0 : distances[room.index()]));
    }
    rooms.forEach(room -> places.add(room.rest()));
  }

  /** Adds where robots started, the place farthest from all rooms first. */
  private void addStarts() {
    List<Point> starts = new ArrayList<>(house.plan().starts());
    starts.sort(
        Comparator.comparingInt(start -> -Arrays.stream(house.distancesMm(start)).min().orElse(0)));
    places.addAll(starts);
  }
}

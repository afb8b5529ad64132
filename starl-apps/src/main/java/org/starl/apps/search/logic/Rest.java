package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;

/**
 * Where a robot goes that has nothing to do, so that it is in nobody's way: deep into the room where
 * it is; from the hall into the nearest one, unless it has not left its start. Strand only.
 */
final class Rest {

  private static final long PATIENCE_MS = 10_000;
  private static final double SAME_MM = 300;

  private final GlobalVarHolder gvh;
  private final House house;
  private final Drive drive;
  private final List<Room> rooms = new ArrayList<>();
  private boolean underWay;
  private boolean resting;

  Rest(GlobalVarHolder gvh, House house, Drive drive) {
    this.gvh = gvh;
    this.house = house;
    this.drive = drive;
  }

  /** It has nothing to do from now on. */
  void begin() {
    rooms.clear();
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
    if (rooms.isEmpty()) {
      rooms.addAll(byDistance());
    }
    if (rooms.isEmpty()) {
      resting = true;
      return;
    }
    underWay = true;
    drive.to(rooms.remove(0).rest(), PATIENCE_MS);
  }

  private boolean isAtItsStart() {
    for (Point start : house.plan().starts()) {
      if (gvh.gps.pose().distanceMm(start) < SAME_MM) {
        return true;
      }
    }
    return false;
  }

  private List<Room> byDistance() {
    Point here = gvh.gps.pose().at();
    int[] distances = house.distancesMm(here);
    int mine = house.roomAt(here);
    if (mine >= 0) {
      distances[mine] = 0;
    }
    List<Room> all = new ArrayList<>();
    for (Room room : house.rooms()) {
      if (room.isEnterable()) {
        all.add(room);
      }
    }
    all.sort(Comparator.comparingInt(room -> distances[room.index()]));
    return all;
  }
}

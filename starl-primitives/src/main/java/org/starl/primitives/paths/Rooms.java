package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.algorithm.Area;
import org.locationtech.jts.algorithm.RayCrossingCounter;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.CoordinateArrays;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Location;

/**
 * The rooms of a free space: the holes in the solid area. No path connects points in different
 * rooms, except along a line without width. This answer saves a search through all reachable
 * corners.
 */
final class Rooms {

  static final int NONE = -1;

  private static final class Room {
    private final Coordinate[] ring;
    private final Envelope box;
    private final double area;

    Room(Coordinate[] ring, double area) {
      this.ring = ring;
      this.box = CoordinateArrays.envelope(ring);
      this.area = area;
    }
  }

  private final List<Room> rooms = new ArrayList<>();

  /**
   * @param rings closed, the solid side on the left: holes run clockwise
   */
  Rooms(List<Coordinate[]> rings) {
    for (Coordinate[] ring : rings) {
      double area = Area.ofRingSigned(ring);
      if (area > 0) {
        rooms.add(new Room(ring, area));
      }
    }
  }

  /** The smallest hole that contains a point, its border included. */
  int at(int px, int py) {
    Coordinate point = new Coordinate(px, py);
    int best = NONE;
    for (int i = 0; i < rooms.size(); i++) {
      Room room = rooms.get(i);
      boolean isLess = best == NONE || room.area < rooms.get(best).area;
      if (isLess
          && room.box.contains(point)
          && RayCrossingCounter.locatePointInRing(point, room.ring) != Location.EXTERIOR) {
        best = i;
      }
    }
    return best;
  }

  Envelope box(int room) {
    return rooms.get(room).box;
  }
}

package org.starl.apps.maze.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;

/** What a robot believes to be in the way: its map, and what contacts have proven. Immutable. */
record Belief(Obstacles map, List<Mark> marks) {

  Belief {
    marks = List.copyOf(marks);
  }

  Belief plus(List<Mark> more) {
    List<Mark> all = new ArrayList<>(marks);
    all.addAll(more);
    return new Belief(map, all);
  }

  /** All marks, for a body that is wider by a part of the margin. */
  List<Polygon> places(double part) {
    List<Polygon> places = new ArrayList<>();
    for (Mark mark : marks) {
      Polygon place = mark.place(part);
      if (place != null) {
        places.add(place);
      }
    }
    return places;
  }

  /** Whether a place lies in a mark, for a body that is wider by the margin. */
  boolean isMarked(Point at) {
    for (Polygon place : places(1)) {
      if (place.contains(at)) {
        return true;
      }
    }
    return false;
  }
}

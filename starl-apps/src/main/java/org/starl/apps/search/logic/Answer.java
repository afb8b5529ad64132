package org.starl.apps.search.logic;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** How a search ends: robots send it, agree on it and return it. */
public sealed interface Answer {

  /** Every room was searched in full, and nothing was found. */
  Answer NOTHING = new Nothing();

  /**
   * A thing was seen.
   *
   * @param xMm its place by the finder's sensor
   */
  record Found(String thing, long xMm, long yMm, RobotId finder) implements Answer {
    @Override
    public String toString() {
      return "found " + thing + " at " + xMm + "," + yMm + " by " + finder;
    }
  }

  /** Nothing was found in any room. */
  record Nothing() implements Answer {
    @Override
    public String toString() {
      return "nothing there";
    }
  }

  /** Nothing was found, and these rooms could not be searched in full; in order. */
  record GaveUp(List<String> rooms) implements Answer {
    public GaveUp {
      rooms = List.copyOf(rooms);
    }

    @Override
    public String toString() {
      return "gave up, could not search " + String.join(" ", rooms);
    }
  }

  Shape<Answer> SHAPE =
      Shapes.oneOf(
          Answer.class,
          Shapes.of(
              Found.class,
              part("thing", TEXT, Found::thing),
              part("xMm", LONG, Found::xMm),
              part("yMm", LONG, Found::yMm),
              part("finder", ROBOT, Found::finder),
              Found::new),
          Shapes.of(Nothing.class, Nothing::new),
          Shapes.of(
              GaveUp.class,
              part("rooms", Shapes.list(TEXT, Report.MAX_ROOMS), GaveUp::rooms),
              GaveUp::new));

  /** A thing was seen, by the finder's sensor at {@code at}. */
  static Answer found(String thing, Point at, RobotId finder) {
    return new Found(thing, Math.round(at.xMm()), Math.round(at.yMm()), finder);
  }

  /** Nothing was found. */
  static Answer nothing(List<String> roomsLeft) {
    return roomsLeft.isEmpty() ? NOTHING : new GaveUp(roomsLeft);
  }
}

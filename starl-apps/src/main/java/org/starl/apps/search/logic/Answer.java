package org.starl.apps.search.logic;

import java.util.List;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/** How a search ends, as text: robots send it, agree on it and return it. */
public final class Answer {

  /** Every room was searched in full, and nothing was found. */
  public static final String NOTHING = "nothing there";

  /** Begins an answer that names the thing, its place in mm and its finder. */
  public static final String FOUND = "found ";

  /** Begins an answer that names the rooms that could not be searched in full, in order. */
  public static final String GAVE_UP = "gave up, could not search ";

  private Answer() {}

  /** A thing was seen, by the finder's sensor at {@code at}. */
  static String found(String thing, Point at, RobotId finder) {
    return FOUND
        + thing
        + " at "
        + Math.round(at.xMm())
        + ","
        + Math.round(at.yMm())
        + " by "
        + finder;
  }

  /** Nothing was found. */
  static String nothing(List<String> roomsLeft) {
    return roomsLeft.isEmpty() ? NOTHING : GAVE_UP + String.join(" ", roomsLeft);
  }
}

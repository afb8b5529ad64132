package org.starl.apps.search.logic;

import java.util.List;
import java.util.stream.Collectors;
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
    return FOUND + thing + " at " + SearchTrace.text(at) + " by " + finder;
  }

  /** Nothing was found. */
  static String nothing(List<Room> left) {
    return left.isEmpty()
        ? NOTHING
        : GAVE_UP + left.stream().map(Room::name).collect(Collectors.joining(" "));
  }
}

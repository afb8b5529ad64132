package org.starl.apps.search.logic;

import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** The names of a search's events in the trace. */
public final class SearchTrace {

  /** {@code source} of this app's trace events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link SearchApp.Location}. */
  public static final String LOCATION = "location";

  /** Variable: the room that this robot searches or drives to; empty for none. */
  public static final String ROOM = "room";

  /** Variable of a leader: its term, then {@code robot=room} for each assignment. */
  public static final String DUTY = "duty";

  /** Variable: the rooms that this robot knows to be searched in full. Action: one was. */
  public static final String SWEPT = "swept";

  /** Action: a room and the legs of its sweep. */
  public static final String SWEEP = "sweep";

  /** Action: a thing was seen, with its place in mm. */
  public static final String FOUND = "found";

  /** Action: the answer with which this robot ends. */
  public static final String ANSWER = "answer";

  private SearchTrace() {}

  /** Whether it is this app's action of that name. */
  public static boolean is(Action action, String name) {
    return action.source().equals(SOURCE) && action.name().equals(name);
  }

  /** Whether it is this app's variable of that name. */
  public static boolean is(Variable variable, String name) {
    return variable.source().equals(SOURCE) && variable.name().equals(name);
  }

  /** A leg as text: {@code 500,1500>900,1500}, or {@code 700,700} for a stop. */
  static String text(Segment leg) {
    return text(leg.from()) + (leg.from().equals(leg.to()) ? "" : ">" + text(leg.to()));
  }

  private static String text(Point point) {
    return Math.round(point.xMm()) + "," + Math.round(point.yMm());
  }
}

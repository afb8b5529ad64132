package org.starl.apps.search.logic;

/** The names under which a search stands in the trace, for whoever checks, draws or tells it. */
public final class SearchTrace {

  /** {@code source} of this app's trace events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link SearchApp.Location}. */
  public static final String LOCATION = "location";

  /** Variable: the room that this robot searches or is on its way to; empty for none. */
  public static final String ROOM = "room";

  /** Variable of a leader: its term, then who is to go where. */
  public static final String DUTY = "duty";

  /** Variable: the rooms that were searched in full, as far as this robot knows. Action: one was. */
  public static final String SWEPT = "swept";

  /** Action: a room and the legs of its sweep. */
  public static final String SWEEP = "sweep";

  /** Action: a thing was seen, with its place. */
  public static final String FOUND = "found";

  /** Action: the answer with which this robot ends. */
  public static final String ANSWER = "answer";

  private SearchTrace() {}
}

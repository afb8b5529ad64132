package org.starl.apps.search.spec;

import java.util.List;
import java.util.function.Supplier;
import org.starl.apps.search.logic.House;
import org.starl.geometry.ItemPosition;
import org.starl.spec.Monitor;

/** Everything that is checked of a search itself. */
public final class SearchSpec {

  private static final long NS_PER_S = 1_000_000_000;

  /** Silence, and the leader's own look at things, twice: the leader may have changed meanwhile. */
  private static final long ASSIGNED_NS = 20 * NS_PER_S;

  private static final long START_NS = 300 * NS_PER_S;
  private static final long ROOM_NS = 180 * NS_PER_S;

  private SearchSpec() {}

  /**
   * Monitors' makers, as each run needs its own.
   *
   * @param things that are there to be found
   */
  public static List<Supplier<? extends Monitor>> of(House house, List<ItemPosition> things) {
    return List.of(
        () -> new Findings(house, things),
        () -> new Ends(toldNs(house)),
        () -> new Assigned(ASSIGNED_NS));
  }

  /**
   * Within this time all is over: one robot alone would search a room in {@link #ROOM_NS}, and as long
   * it may take until everybody has tried in vain to get into a room that somebody dead bars.
   */
  public static long toldNs(House house) {
    return START_NS + 2L * house.rooms().size() * ROOM_NS;
  }
}

package org.starl.apps.search.spec;

import static org.starl.time.Time.NS_PER_S;

import java.util.List;
import java.util.function.Supplier;
import org.starl.apps.search.logic.House;
import org.starl.geometry.ItemPosition;
import org.starl.spec.Monitor;

/** The monitors of a search itself. */
public final class SearchSpec {

  /** Twice the silence and the leader's period: the leader may change meanwhile. */
  private static final long ASSIGNED_NS = 20 * NS_PER_S;

  private static final long START_NS = 300 * NS_PER_S;
  private static final long ROOM_NS = 180 * NS_PER_S;

  private SearchSpec() {}

  /**
   * Suppliers of monitors: each run needs its own.
   *
   * @param things the things to find
   * @param staysDown whether a robot may crash for good
   */
  public static List<Supplier<? extends Monitor>> of(
      House house, List<ItemPosition> things, boolean staysDown) {
    return List.of(
        () -> new Findings(house, things, staysDown), () -> new Ends(toldNs(house), ASSIGNED_NS));
  }

  /**
   * The bound on a whole search. One robot alone searches a room in {@link #ROOM_NS}; it may take
   * as long again until all robots have failed to enter a room that a dead robot bars.
   */
  public static long toldNs(House house) {
    return START_NS + 2L * house.rooms().size() * ROOM_NS;
  }
}

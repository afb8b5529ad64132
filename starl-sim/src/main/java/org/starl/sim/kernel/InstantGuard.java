package org.starl.sim.kernel;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Ends a run whose events go on at one virtual time without end. The kernel calls it only after
 * {@link #SUSPICIOUS} events at one time, so that it costs nothing otherwise.
 */
final class InstantGuard {

  /** Events at one virtual time, of all robots and the world, before they are counted by robot. */
  static final int SUSPICIOUS = 100_000;

  /** The limit of one robot's actions at one virtual time. */
  static final int MAX_ACTIONS = 100_000;

  /** The limit of the world's events at one virtual time. */
  static final int MAX_WORLD_EVENTS = 1_000_000;

  private final Map<SimStrand, int[]> actions = new LinkedHashMap<>();
  private long countedNs = -1;
  private int worldEvents;
  private @Nullable SimStrand stalled;

  /**
   * Counts an event that is about to run.
   *
   * @throws Stalled if its owner has been over the limit for as many events again, although {@link
   *     #checkAdd} did not stop it: others schedule its events
   */
  void count(long nowNs, @Nullable SimStrand strand) {
    if (nowNs != countedNs) {
      countedNs = nowNs;
      actions.clear();
      worldEvents = 0;
      stalled = null;
    }
    if (strand == null) {
      worldEvents++;
      if (worldEvents > 2 * MAX_WORLD_EVENTS) {
        throw Stalled.world(worldEvents);
      }
      return;
    }
    int[] count = actions.computeIfAbsent(strand, any -> new int[1]);
    count[0]++;
    if (count[0] > 2 * MAX_ACTIONS) {
      throw new RobotError(strand.name(), nowNs, Stalled.actions(count[0]));
    }
    if (count[0] > MAX_ACTIONS) {
      stalled = strand;
    }
  }

  /**
   * Called when {@code current}, or the world, schedules an event for {@code nowNs}.
   *
   * @throws Stalled if it is over its limit; the stack is that of the code that goes on
   */
  void checkAdd(long nowNs, @Nullable SimStrand current) {
    if (nowNs != countedNs) {
      return;
    }
    if (current == null && worldEvents > MAX_WORLD_EVENTS) {
      throw Stalled.world(worldEvents);
    }
    if (current != null && current == stalled) {
      throw Stalled.actions(MAX_ACTIONS);
    }
  }
}

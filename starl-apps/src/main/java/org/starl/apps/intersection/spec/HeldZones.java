package org.starl.apps.intersection.spec;

import java.util.Collection;
import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexFact;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * The zones and places that each robot holds (crit_set), read from the mutexes' events in a trace. No
 * section belongs to two mutexes.
 */
public final class HeldZones {

  private final Map<RobotId, SortedMap<String, Hold>> held = new TreeMap<>();

  private record Hold(Instance mutex, ProcessId process) {
    boolean isOf(Instance otherMutex, ProcessId other) {
      return mutex.equals(otherMutex) && process.equals(other);
    }
  }

  /** An independent copy of the present state. */
  public HeldZones copy() {
    HeldZones copy = new HeldZones();
    held.forEach((robot, zones) -> copy.held.put(robot, new TreeMap<>(zones)));
    return copy;
  }

  /** Takes the next event of the trace. */
  public void observe(TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof MutexFact fact) {
      observe(action.source(), fact);
    }
  }

  private void observe(Instance mutex, MutexFact event) {
    SortedMap<String, Hold> zones =
        held.computeIfAbsent(event.who().robot(), robot -> new TreeMap<>());
    switch (event) {
      case MutexFact.OdMutex grant -> {
        zones.values().removeIf(hold -> hold.isOf(mutex, grant.who()));
        grant.held().forEach(zone -> zones.put(zone, new Hold(mutex, grant.who())));
      }
      case MutexFact.Release release ->
          zones
              .entrySet()
              .removeIf(zone ->
                  release.given().contains(zone.getKey())
                      && zone.getValue().isOf(mutex, release.who()));
      // The robot keeps only those sections of its earlier processes that it is in.
      case MutexFact.StandsIn declared ->
          zones
              .entrySet()
              .removeIf(zone ->
                  zone.getValue().mutex.equals(mutex)
                      && zone.getValue().process.boot() < declared.who().boot()
                      && !declared.sections().contains(zone.getKey()));
      default -> {
        // Neither grants nor releases a section.
      }
    }
    if (zones.isEmpty()) {
      held.remove(event.who().robot());
    }
  }

  /** The crit_set of {@code robot}: the sections that it has access to. */
  public SortedSet<String> held(RobotId robot) {
    return new TreeSet<>(held.getOrDefault(robot, Collections.emptySortedMap()).keySet());
  }

  /** Whether {@code robot} has access to {@code zone}. */
  boolean holds(RobotId robot, String zone) {
    return held.getOrDefault(robot, Collections.emptySortedMap()).containsKey(zone);
  }

  /** Whether {@code robot} has access to all of {@code zones}. */
  boolean holdsAll(RobotId robot, Collection<String> zones) {
    return held.getOrDefault(robot, Collections.emptySortedMap()).keySet().containsAll(zones);
  }

  /** All robots that hold something, in order. */
  Set<RobotId> holders() {
    return held.keySet();
  }
}

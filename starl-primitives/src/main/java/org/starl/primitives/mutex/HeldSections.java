package org.starl.primitives.mutex;

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
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * The sections that each robot holds (crit_set), read from the mutexes' events in a trace. No section
 * belongs to two mutexes.
 */
public final class HeldSections {

  private final Map<RobotId, SortedMap<String, Hold>> held = new TreeMap<>();

  private record Hold(Instance mutex, ProcessId process) {
    boolean isOf(Instance otherMutex, ProcessId other) {
      return mutex.equals(otherMutex) && process.equals(other);
    }
  }

  /** An independent copy of the present state. */
  public HeldSections copy() {
    HeldSections copy = new HeldSections();
    held.forEach((robot, sections) -> copy.held.put(robot, new TreeMap<>(sections)));
    return copy;
  }

  /** Takes the next event of the trace. */
  public void observe(TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof MutexFact fact) {
      observe(action.source(), fact);
    }
  }

  private void observe(Instance mutex, MutexFact event) {
    SortedMap<String, Hold> sections =
        held.computeIfAbsent(event.who().robot(), robot -> new TreeMap<>());
    switch (event) {
      case MutexFact.OdMutex grant -> {
        sections.values().removeIf(hold -> hold.isOf(mutex, grant.who()));
        grant.held().forEach(section -> sections.put(section, new Hold(mutex, grant.who())));
      }
      case MutexFact.Release release ->
          sections
              .entrySet()
              .removeIf(section ->
                  release.given().contains(section.getKey())
                      && section.getValue().isOf(mutex, release.who()));
      // The robot keeps only those sections of its earlier processes that it is in.
      case MutexFact.StandsIn declared ->
          sections
              .entrySet()
              .removeIf(section ->
                  section.getValue().mutex.equals(mutex)
                      && section.getValue().process.boot() < declared.who().boot()
                      && !declared.sections().contains(section.getKey()));
      default -> {
        // Neither grants nor releases a section.
      }
    }
    if (sections.isEmpty()) {
      held.remove(event.who().robot());
    }
  }

  /** The crit_set of {@code robot}: the sections that it has access to. */
  public SortedSet<String> held(RobotId robot) {
    return new TreeSet<>(held.getOrDefault(robot, Collections.emptySortedMap()).keySet());
  }

  /** Whether {@code robot} has access to {@code section}. */
  public boolean holds(RobotId robot, String section) {
    return held.getOrDefault(robot, Collections.emptySortedMap()).containsKey(section);
  }

  /** Whether {@code robot} has access to all of {@code sections}. */
  public boolean holdsAll(RobotId robot, Collection<String> sections) {
    return held.getOrDefault(robot, Collections.emptySortedMap()).keySet().containsAll(sections);
  }

  /** All robots that hold something, in order. */
  public Set<RobotId> holders() {
    return held.keySet();
  }
}

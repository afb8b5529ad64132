package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.RobotId;
import org.starl.primitives.mutex.MutexEvent;
import org.starl.primitives.mutex.MutexTrace;
import org.starl.trace.TraceEvent;

/** Who holds and who requests which zones, as the mutex's trace tells it: crit_set and req_set. */
public final class HeldZones {

  private static final SortedSet<String> NONE = Collections.emptySortedSet();

  private final Map<RobotId, SortedSet<String>> held = new TreeMap<>();
  private final Map<RobotId, SortedSet<String>> requested = new TreeMap<>();
  private final Set<RobotId> refused = new TreeSet<>();

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    MutexTrace.read(event).ifPresent(this::observe);
  }

  private void observe(MutexEvent event) {
    RobotId robot = event.who().robot();
    switch (event) {
      case MutexEvent.DoMutex request -> {
        requested.put(robot, request.want());
        refused.remove(robot);
      }
      case MutexEvent.OdMutex grant -> {
        requested.remove(robot);
        held.put(robot, new TreeSet<>(grant.held()));
      }
      case MutexEvent.Release release -> held.put(robot, release.left());
      case MutexEvent.Withdraw withdrawal -> {
        requested.remove(robot);
        refused.add(robot);
      }
      case MutexEvent.Grant consent -> {
        // Consent of one peer gives nothing yet.
      }
      case MutexEvent.Known known -> {
        // Nor does knowing whom to ask.
      }
      case MutexEvent.Learned view -> {
        // Nor does who takes part.
      }
      case MutexEvent.Fence vow -> {
        // A vow takes nothing from whom it is about.
      }
      case MutexEvent.StandsIn word -> {
        // A new start has no access yet.
      }
    }
  }

  /** crit_set: what {@code robot} has access to. */
  public SortedSet<String> held(RobotId robot) {
    return held.getOrDefault(robot, NONE);
  }

  /** Whether {@code robot}'s latest request ended without access. */
  boolean isRefused(RobotId robot) {
    return refused.contains(robot);
  }

  /** Everybody who ever held anything, in order. */
  Set<RobotId> holders() {
    return held.keySet();
  }

  /** req_set: what {@code robot} waits for. */
  SortedSet<String> requested(RobotId robot) {
    return requested.getOrDefault(robot, NONE);
  }

  /** Reads a variable whose value is a list: {@code [A, C, D1]}. */
  static List<String> list(String value) {
    List<String> names = new ArrayList<>();
    for (String name : value.substring(1, value.length() - 1).split(", ", -1)) {
      if (!name.isEmpty()) {
        names.add(name);
      }
    }
    return names;
  }
}

package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/**
 * {@code Inv_mux_safety} (paper, Figure 6): the crit_sets of any two cars are disjoint. The mutex's
 * {@code Exclusive} says the same of processes; this says it of cars, over all their processes.
 */
final class MuxSafety implements Monitor {

  private static final String LEMMA = "Inv_mux_safety";

  private final HeldZones zones = new HeldZones();

  @Override
  public List<String> lemmas() {
    return List.of(LEMMA);
  }

  @Override
  public String description(String lemma) {
    return "No two cars hold the same zone.";
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (!(event instanceof TraceEvent.Action)) {
      zones.observe(event);
      return; // cannot be a grant
    }
    RobotId robot = event.robot();
    SortedSet<String> before = zones.held(robot);
    zones.observe(event);
    SortedSet<String> after = zones.held(robot);
    if (before.containsAll(after)) {
      return;
    }
    report.checked(LEMMA);
    for (RobotId other : zones.holders()) {
      SortedSet<String> both = new TreeSet<>(after);
      both.retainAll(zones.held(other));
      if (!other.equals(robot) && !both.isEmpty()) {
        report.violated(LEMMA, event.timeNs(), List.of(other, robot), "both hold " + both);
      }
    }
  }
}

package org.starl.apps.search.spec;

import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.search.logic.SearchTrace;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code assigned}: a leader that is up takes its room from a robot that is down, within a bound.
 * Of several leaders the one of the latest term counts. Nothing is owed once a robot has ended.
 */
final class Assigned implements Monitor {

  private static final String ASSIGNED = "assigned";

  private final Within<RobotId> within;
  private final FaultState circumstances = new FaultState();

  /** What each leader has told last: its term, then {@code robot=room} for each assignment. */
  private final SortedMap<RobotId, List<String>> duties = new TreeMap<>();

  private final Set<RobotId> owed = new TreeSet<>();
  private boolean isOver;

  Assigned(long boundNs) {
    within = new Within<>(boundNs);
  }

  @Override
  public List<String> lemmas() {
    return List.of(ASSIGNED);
  }

  @Override
  public String description(String lemma) {
    return "A leader takes its room from a robot that is down, within the bound.";
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    boolean isChanged = circumstances.observe(event);
    if (isChanged) {
      within.assumeAll(circumstances.isFaultFree(), event.timeNs());
    }
    if (event instanceof Variable variable && SearchTrace.is(variable, SearchTrace.DUTY)) {
      if (variable.value().isEmpty()) {
        duties.remove(variable.robot());
      } else {
        duties.put(variable.robot(), List.of(variable.value().split(" ", -1)));
      }
      report.checked(ASSIGNED);
      isChanged = true;
    } else if (event instanceof Action action && SearchTrace.is(action, SearchTrace.ANSWER)) {
      isOver = true;
      isChanged = true;
    }
    if (isChanged) {
      review(event.timeNs());
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    within.expire(
        endNs,
        (robot, sinceNs, deadlineNs) ->
            report.violated(
                ASSIGNED,
                deadlineNs,
                List.of(robot),
                "is down, and still has its room: " + String.join(" ", latestDuty())));
  }

  private void review(long nowNs) {
    Set<RobotId> downWithRoom = new TreeSet<>();
    Collection<String> duty = isOver ? List.of() : latestDuty();
    for (String entry : duty) {
      int equals = entry.indexOf('=');
      if (equals > 0 && !circumstances.isUp(new RobotId(entry.substring(0, equals)))) {
        downWithRoom.add(new RobotId(entry.substring(0, equals)));
      }
    }
    owed.removeAll(downWithRoom);
    owed.forEach(within::stop);
    owed.clear();
    owed.addAll(downWithRoom);
    owed.forEach(robot -> within.start(robot, nowNs));
  }

  /** What the leader of the latest term has told, if it is up. */
  private List<String> latestDuty() {
    long latest = 0;
    RobotId leader = null;
    for (RobotId robot : duties.keySet()) {
      long term = Long.parseLong(duties.getOrDefault(robot, List.of()).get(0));
      if (term > latest) {
        latest = term;
        leader = robot;
      }
    }
    return leader != null && circumstances.isUp(leader)
        ? duties.getOrDefault(leader, List.of())
        : List.of();
  }
}

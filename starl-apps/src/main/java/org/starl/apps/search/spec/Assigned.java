package org.starl.apps.search.spec;

import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.search.logic.SearchTrace;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code assigned}: a leader that is up takes a room, within a bound, from a robot that is down. Of
 * several leaders the one of the latest term counts. Nothing is owed once somebody has ended.
 */
final class Assigned implements Monitor {

  private static final String ASSIGNED = "assigned";

  private final Within<RobotId> within;
  private final Circumstances circumstances = new Circumstances();
  private final SortedMap<RobotId, String> duties = new TreeMap<>();
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
  public String says(String lemma) {
    return "No room stays with a robot that is down: a leader takes it back within the bound.";
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    boolean isChanged = circumstances.observe(event);
    if (isChanged) {
      within.assumeAll(circumstances.isFair(), event.timeNs());
    }
    if (event instanceof Variable variable
        && variable.source().equals(SearchTrace.SOURCE)
        && variable.name().equals(SearchTrace.DUTY)) {
      duties.put(variable.robot(), variable.value());
      report.checked(ASSIGNED);
      isChanged = true;
    } else if (event instanceof Action action
        && action.source().equals(SearchTrace.SOURCE)
        && action.name().equals(SearchTrace.ANSWER)) {
      isOver = true;
      isChanged = true;
    }
    if (isChanged) {
      review(event.timeNs());
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
  }

  private void review(long nowNs) {
    Set<RobotId> downWithRoom = new TreeSet<>();
    for (String entry : isOver ? new String[0] : latestDuty().split(" ", -1)) {
      int equals = entry.indexOf('=');
      if (equals > 0) {
        RobotId robot = new RobotId(entry.substring(0, equals));
        if (!circumstances.isUp(robot)) {
          downWithRoom.add(robot);
        }
      }
    }
    for (RobotId robot : owed) {
      if (!downWithRoom.contains(robot)) {
        within.settle(robot);
      }
    }
    owed.clear();
    owed.addAll(downWithRoom);
    owed.forEach(robot -> within.owe(robot, nowNs));
  }

  /** What the leader of the latest term says, if it is up. */
  private String latestDuty() {
    long latest = 0;
    RobotId leader = null;
    for (RobotId robot : duties.keySet()) {
      String duty = duties.getOrDefault(robot, "");
      long term = duty.isEmpty() ? 0 : Long.parseLong(duty.split(" ", -1)[0]);
      if (term > latest) {
        latest = term;
        leader = robot;
      }
    }
    return leader != null && circumstances.isUp(leader) ? duties.getOrDefault(leader, "") : "";
  }

  private void expire(long nowNs, Report report) {
    within.expire(
        nowNs,
        (robot, sinceNs, deadlineNs) ->
            report.violated(
                ASSIGNED,
                deadlineNs,
                List.of(robot),
                "is down, and still has its room: " + latestDuty()));
  }
}

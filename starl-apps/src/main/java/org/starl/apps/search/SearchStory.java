package org.starl.apps.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.search.logic.Answer;
import org.starl.apps.search.logic.SearchTrace;
import org.starl.id.RobotId;
import org.starl.sim.SimResult;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** Who led, who searched which room, and how it ended. */
final class SearchStory implements Story {

  private static final double NS_PER_S = 1e9;

  private final List<String> lines = new ArrayList<>();
  private final SortedMap<RobotId, Long> endedNs = new TreeMap<>();
  private final SortedSet<String> answers = new TreeSet<>();
  private final SortedSet<RobotId> leaders = new TreeSet<>();
  private final SortedSet<RobotId> came = new TreeSet<>();
  private final SortedMap<String, Long> sweptNs = new TreeMap<>();

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Joined joined -> came.add(joined.robot());
      case Fault fault -> {
        if (fault.name().equals(Fault.CRASH) || fault.name().equals(Fault.RESTART)) {
          leaders.remove(fault.robot());
          boolean isCrash = fault.name().equals(Fault.CRASH);
          tell(fault, isCrash ? "crashes" : "starts anew");
        }
      }
      case Variable variable -> {
        if (variable.source().equals(SearchTrace.SOURCE)) {
          changed(variable);
        }
      }
      case Action action -> {
        if (action.source().equals(SearchTrace.SOURCE)) {
          acted(action);
        }
      }
      default -> {
        // Of no account here.
      }
    }
  }

  private void changed(Variable variable) {
    if (variable.name().equals(SearchTrace.DUTY)) {
      if (variable.value().isEmpty()) {
        leaders.remove(variable.robot());
      } else if (leaders.add(variable.robot())) {
        tell(variable, "leads");
      }
    } else if (variable.name().equals(SearchTrace.ROOM) && !variable.value().isEmpty()) {
      tell(variable, "takes room " + variable.value());
    }
  }

  private void acted(Action action) {
    if (action.name().equals(SearchTrace.SWEPT)) {
      sweptNs.putIfAbsent(action.args().get(0), action.timeNs());
      tell(action, "has searched room " + action.args().get(0) + " in full");
    } else if (action.name().equals(SearchTrace.FOUND)) {
      tell(action, "sees " + action.args().get(0));
    } else if (action.name().equals(SearchTrace.ANSWER)) {
      endedNs.put(action.robot(), action.timeNs());
      if (answers.add(action.args().get(0))) {
        tell(action, "ends: " + action.args().get(0));
      }
    }
  }

  private void tell(TraceEvent event, String what) {
    lines.add(
        String.format(
            Locale.ROOT, "%6.1f s  %s %s", event.timeNs() / NS_PER_S, event.robot(), what));
  }

  @Override
  public void finished(SimResult result) {
    result.unfinished().forEach(robot -> lines.add(robot + " has not ended"));
  }

  @Override
  public List<String> lines() {
    return List.copyOf(lines);
  }

  @Override
  public Measures measures() {
    SortedMap<String, Double> figures = new TreeMap<>();
    figures.put("rooms_searched", (double) sweptNs.size());
    SortedMap<String, Long> counts = new TreeMap<>();
    for (String answer : answers) {
      String kind =
          answer.startsWith(Answer.FOUND)
              ? "found"
              : answer.equals(Answer.NOTHING) ? "nothing there" : "gave up";
      counts.merge("answer: " + kind, 1L, Long::sum);
    }
    return new Measures(
        came.size(), endedNs.size(), new ArrayList<>(endedNs.values()), figures, counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.when("rooms searched", List.copyOf(sweptNs.values())),
        Sample.howLong("time until a robot had its answer", List.copyOf(endedNs.values())));
  }
}

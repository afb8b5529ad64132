package org.starl.apps.search;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/** Which robots led, which robot searched which room, and how the search ended. */
final class SearchStory implements Story {

  private final List<String> lines = new ArrayList<>();
  private final SortedMap<RobotId, Long> endedNs = new TreeMap<>();
  private final SortedSet<String> answers = new TreeSet<>();
  private final SortedSet<RobotId> leaders = new TreeSet<>();
  private final SortedSet<RobotId> joined = new TreeSet<>();
  private final SortedMap<String, Long> sweptNs = new TreeMap<>();

  @Override
  public void observed(TraceEvent event) {
    RobotId robot = event.robot();
    switch (event) {
      case TraceEvent.Joined any -> joined.add(robot);
      case Fault fault when fault.name().equals(Fault.CRASH) -> {
        leaders.remove(robot);
        tell(fault, "crashes");
      }
      case Fault fault when fault.name().equals(Fault.RESTART) -> tell(fault, "restarts");
      case Variable duty when SearchTrace.is(duty, SearchTrace.DUTY) -> {
        if (duty.value().isEmpty()) {
          leaders.remove(robot);
        } else if (leaders.add(robot)) {
          tell(duty, "leads");
        }
      }
      case Variable room when SearchTrace.is(room, SearchTrace.ROOM) -> {
        if (!room.value().isEmpty()) {
          tell(room, "takes room " + room.value());
        }
      }
      case Action swept when SearchTrace.is(swept, SearchTrace.SWEPT) -> {
        sweptNs.putIfAbsent(swept.args().get(0), swept.timeNs());
        tell(swept, "has searched room " + swept.args().get(0) + " in full");
      }
      case Action found when SearchTrace.is(found, SearchTrace.FOUND) ->
          tell(found, "sees " + found.args().get(0));
      case Action answer when SearchTrace.is(answer, SearchTrace.ANSWER) -> {
        endedNs.put(robot, answer.timeNs());
        if (answers.add(answer.args().get(0))) {
          tell(answer, "ends: " + answer.args().get(0));
        }
      }
      default -> {
        // Not part of the story.
      }
    }
  }

  private void tell(TraceEvent event, String what) {
    double seconds = Time.seconds(event.timeNs());
    lines.add(String.format(Locale.ROOT, "%6.1f s  %s %s", seconds, event.robot(), what));
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
    SortedMap<String, Long> counts = new TreeMap<>();
    for (String answer : answers) {
      boolean isFound = answer.startsWith(Answer.FOUND);
      String kind = isFound ? "found" : answer.equals(Answer.NOTHING) ? answer : "gave up";
      counts.merge("answer: " + kind, 1L, Long::sum);
    }
    List<Long> ends = List.copyOf(endedNs.values());
    return new Measures(
        joined.size(),
        ends.size(),
        ends,
        new TreeMap<>(Map.of("rooms_searched", (double) sweptNs.size())),
        counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.when("rooms searched", List.copyOf(sweptNs.values())),
        Sample.howLong("time until a robot had its answer", List.copyOf(endedNs.values())));
  }
}

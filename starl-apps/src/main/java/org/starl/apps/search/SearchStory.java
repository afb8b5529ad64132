package org.starl.apps.search;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.search.logic.Answer;
import org.starl.apps.search.logic.SearchFact;
import org.starl.apps.search.logic.SearchFact.Assigned;
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
  private final Set<Answer> answers = new LinkedHashSet<>();
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
      case Variable variable -> changed(variable);
      case Action action when action.fact() instanceof SearchFact fact -> acted(action, fact);
      default -> {
        // Not part of the story.
      }
    }
  }

  private void changed(Variable variable) {
    Assigned duty = variable.of(SearchFact.DUTY);
    String room = variable.of(SearchFact.ROOM);
    if (duty != null && !duty.isLeading()) {
      leaders.remove(variable.robot());
    } else if (duty != null && leaders.add(variable.robot())) {
      tell(variable, "leads");
    } else if (room != null && !room.isEmpty()) {
      tell(variable, "takes room " + room);
    }
  }

  private void acted(Action action, SearchFact fact) {
    switch (fact) {
      case SearchFact.Swept swept -> {
        sweptNs.putIfAbsent(swept.room(), action.timeNs());
        tell(action, "has searched room " + swept.room() + " in full");
      }
      case SearchFact.Found found -> tell(action, "sees " + found.thing());
      case SearchFact.Ended ended -> {
        endedNs.put(action.robot(), action.timeNs());
        if (answers.add(ended.answer())) {
          tell(action, "ends: " + ended.answer());
        }
      }
      case SearchFact.Planned planned -> {
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
    for (Answer answer : answers) {
      String kind =
          switch (answer) {
            case Answer.Found found -> "found";
            case Answer.Nothing nothing -> nothing.toString();
            case Answer.GaveUp gaveUp -> "gave up";
          };
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

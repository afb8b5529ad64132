package org.starl.apps.maze;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.maze.logic.Answer;
import org.starl.apps.maze.logic.MazeTrace;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;

/** Reports each answer: when, and after how many marks from contacts. */
final class MazeStory implements Story {

  private static final double NS_PER_S = 1e9;

  private final int goals;
  private final List<String> lines = new ArrayList<>();
  private final Map<RobotId, Integer> marks = new TreeMap<>();
  private final Map<RobotId, Long> sinceNs = new TreeMap<>();
  private final List<Long> waitsNs = new ArrayList<>();
  private final List<Long> answeredNs = new ArrayList<>();
  private final SortedMap<String, Long> counts = new TreeMap<>();

  /**
   * @param goals of all robots
   */
  MazeStory(int goals) {
    this.goals = goals;
    for (Answer answer : Answer.values()) {
      counts.put(word(answer), 0L);
    }
    counts.put("contacts", 0L);
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof Joined joined) {
      sinceNs.put(joined.robot(), joined.timeNs());
    } else if (event instanceof Action action && action.source().equals(MazeTrace.SOURCE)) {
      if (action.name().equals(MazeTrace.MARK)) {
        marks.merge(action.robot(), 1, Integer::sum);
        counts.merge("contacts", 1L, Long::sum);
      } else if (action.name().equals(MazeTrace.ANSWER)) {
        answered(action.robot(), action.args(), action.timeNs());
      }
    }
  }

  private void answered(RobotId robot, List<String> args, long timeNs) {
    String goal = args.get(0);
    Answer answer = Answer.valueOf(args.get(1));
    String what =
        switch (answer) {
          case REACHED -> "is at " + goal;
          case NO_WAY -> "has proven that there is no way to " + goal;
          case GAVE_UP -> "gave up on " + goal;
        };
    int contacts = marks.getOrDefault(robot, 0);
    String learned = contacts == 0 ? "" : ", " + contacts + " marks from contacts so far";
    lines.add(
        String.format(Locale.ROOT, "%8.1f s  %s %s%s", timeNs / NS_PER_S, robot, what, learned));
    counts.merge(word(answer), 1L, Long::sum);
    if (answer != Answer.GAVE_UP) {
      answeredNs.add(timeNs);
      waitsNs.add(timeNs - sinceNs.getOrDefault(robot, 0L));
    }
  }

  private static String word(Answer answer) {
    return answer.name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  @Override
  public List<String> lines() {
    return List.copyOf(lines);
  }

  @Override
  public Measures measures() {
    return new Measures(goals, waitsNs.size(), waitsNs, new TreeMap<>(), counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.when("goals reached or proven out of reach", answeredNs),
        Sample.howLong("time from a robot's start to each of its answers", waitsNs));
  }
}

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
import org.starl.apps.maze.logic.MazeFact;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * Reports each answer: when, and after how many marks from contacts. All robots start at time 0.
 */
final class MazeStory implements Story {

  private static final String CONTACTS = "contacts";

  private final int goals;
  private final List<String> lines = new ArrayList<>();
  private final Map<RobotId, Integer> marks = new TreeMap<>();
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
    counts.put(CONTACTS, 0L);
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof MazeFact fact) {
      switch (fact) {
        case MazeFact.Marked marked -> {
          marks.merge(action.robot(), 1, Integer::sum);
          counts.merge(CONTACTS, 1L, Long::sum);
        }
        case MazeFact.Answered answered -> answered(action, answered.goal(), answered.answer());
      }
    }
  }

  private void answered(Action action, String goal, Answer answer) {
    String result =
        switch (answer) {
          case REACHED -> "is at " + goal;
          case NO_WAY -> "has proven that there is no way to " + goal;
          case GAVE_UP -> "gave up on " + goal;
        };
    int contacts = marks.getOrDefault(action.robot(), 0);
    String learned = contacts == 0 ? "" : ", " + contacts + " marks from contacts so far";
    double seconds = Time.seconds(action.timeNs());
    lines.add(
        String.format(Locale.ROOT, "%8.1f s  %s %s%s", seconds, action.robot(), result, learned));
    counts.merge(word(answer), 1L, Long::sum);
    if (answer != Answer.GAVE_UP) {
      answeredNs.add(action.timeNs());
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
    return new Measures("goals", goals, answeredNs.size(), answeredNs, new TreeMap<>(), counts);
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.when("goals reached or proven out of reach", answeredNs),
        Sample.howLong("time from a robot's start to each of its answers", answeredNs));
  }
}

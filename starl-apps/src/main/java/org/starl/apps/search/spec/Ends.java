package org.starl.apps.search.spec;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.search.logic.SearchTrace;
import org.starl.id.RobotId;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.InstanceSpec;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code agreed} and {@code ended}: all robots end, with one answer. {@code assigned}: a leader that
 * is up takes its room from a robot that is down, until a robot has ended; of several leaders the
 * one of the latest term counts.
 */
final class Ends extends InstanceSpec<Ends.Search> {

  private static final String AGREED = "agreed";
  private static final String ENDED = "ended";
  private static final String ASSIGNED = "assigned";

  private final Deadlines ends;
  private final Deadlines assigned;

  Ends(long endedWithinNs, long assignedWithinNs) {
    super(SearchTrace.SOURCE::equals);
    lemma(AGREED, "All robots that end have one answer.");
    ends =
        progress(
            ENDED,
            "Every robot that is up ends with an answer, within the bound.",
            endedWithinNs,
            sinceNs -> "has searched since " + sinceNs + " ns, no end");
    assigned =
        progress(
            ASSIGNED,
            "A leader takes its room from a robot that is down, within the bound.",
            assignedWithinNs,
            sinceNs -> "is down, and still has its room: " + String.join(" ", latestDuty()));
  }

  /** What the robots have told. */
  static final class Search {
    private final SortedSet<RobotId> robots = new TreeSet<>();
    private final SortedMap<RobotId, String> answers = new TreeMap<>();

    /** What each leader has told last: its term, then {@code robot=room} for each assignment. */
    private final SortedMap<RobotId, List<String>> duties = new TreeMap<>();
  }

  @Override
  protected Search begin(String source) {
    return new Search();
  }

  private Search search() {
    return instance(SearchTrace.SOURCE);
  }

  private static ProcessKey key(RobotId robot) {
    return new ProcessKey(SearchTrace.SOURCE, robot);
  }

  @Override
  protected void changed(Variable variable, Report report) {
    RobotId robot = variable.robot();
    search().robots.add(robot);
    if (!search().answers.containsKey(robot)) {
      ends.start(key(robot), variable.timeNs());
    }
    if (variable.name().equals(SearchTrace.DUTY)) {
      report.checked(ASSIGNED);
      if (variable.value().isEmpty()) {
        search().duties.remove(robot);
      } else {
        search().duties.put(robot, Arrays.asList(variable.value().split(" ", -1)));
      }
    }
  }

  @Override
  protected void acted(Action action, Report report) {
    if (!action.name().equals(SearchTrace.ANSWER)) {
      return;
    }
    ends.meet(key(action.robot()), report);
    report.checked(AGREED);
    String answer = action.args().get(0);
    search()
        .answers
        .forEach((other, theirs) -> {
          if (!theirs.equals(answer)) {
            report.violated(
                AGREED,
                action.timeNs(),
                List.copyOf(new TreeSet<>(List.of(other, action.robot()))),
                other
                    + " ended with '"
                    + theirs
                    + "', "
                    + action.robot()
                    + " with '"
                    + answer
                    + "'");
          }
        });
    search().answers.put(action.robot(), answer);
  }

  @Override
  protected void ended(RobotId robot) {
    ends.stop(key(robot));
  }

  @Override
  protected void review(long nowNs, Report report) {
    List<String> duty = latestDuty();
    for (RobotId robot : search().robots) {
      boolean hasRoom = duty.stream().anyMatch(entry -> entry.startsWith(robot + "="));
      if (hasRoom && !faults.isUp(robot)) {
        assigned.start(key(robot), nowNs);
      } else {
        assigned.stop(key(robot));
      }
    }
    boolean isFaultFree = faults.isFaultFree();
    boolean isMajorityUp = hasMajorityUp(search().robots);
    assigned.assumeEach(robot -> isFaultFree, nowNs);
    ends.assumeEach(robot -> isFaultFree && isMajorityUp, nowNs);
  }

  /** What the leader of the latest term has told, if it is up and no robot has ended. */
  private List<String> latestDuty() {
    return search().duties.entrySet().stream()
        .max(Comparator.comparingLong(told -> Long.parseLong(told.getValue().get(0))))
        .filter(told -> faults.isUp(told.getKey()) && search().answers.isEmpty())
        .map(Map.Entry::getValue)
        .orElse(List.of());
  }
}

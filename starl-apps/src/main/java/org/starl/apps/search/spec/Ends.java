package org.starl.apps.search.spec;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.search.logic.Answer;
import org.starl.apps.search.logic.SearchFact;
import org.starl.id.RobotId;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.InstanceSpec;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code agreed} and {@code ended}: all robots end, with one answer. {@code assigned}: a leader that
 * is up takes its room from a robot that is down, until a robot has ended; of several leaders the
 * one of the latest term counts.
 */
final class Ends extends InstanceSpec<Ends.Search> {

  private static final String AGREED = "search.agreed";
  private static final String ENDED = "search.ended";
  private static final String ASSIGNED = "search.assigned";

  private final Deadlines ends;
  private final Deadlines assigned;

  Ends(long endedWithinNs, long assignedWithinNs) {
    super(Instance.APP.kind());
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
            sinceNs -> "is down, and still has its room: " + latestDuty());
  }

  /** What the robots have told. */
  static final class Search {
    private final SortedSet<RobotId> robots = new TreeSet<>();
    private final SortedMap<RobotId, Answer> answers = new TreeMap<>();

    /** What each leader has assigned last. */
    private final SortedMap<RobotId, SearchFact.Assigned> duties = new TreeMap<>();
  }

  @Override
  protected Search begin(Instance source) {
    return new Search();
  }

  private Search search() {
    return instance(Instance.APP);
  }

  private static ProcessKey key(RobotId robot) {
    return new ProcessKey(Instance.APP, robot);
  }

  @Override
  protected void changed(Variable variable, Report report) {
    RobotId robot = variable.robot();
    search().robots.add(robot);
    if (!search().answers.containsKey(robot)) {
      ends.start(key(robot), variable.timeNs());
    }
    SearchFact.Assigned duty = variable.of(SearchFact.DUTY);
    if (duty != null) {
      report.checked(ASSIGNED);
      if (duty.isLeading()) {
        search().duties.put(robot, duty);
      } else {
        search().duties.remove(robot);
      }
    }
  }

  @Override
  protected void acted(Action action, Report report) {
    if (!(action.fact() instanceof SearchFact.Ended end)) {
      return;
    }
    ends.meet(key(action.robot()), report);
    report.checked(AGREED);
    Answer answer = end.answer();
    search()
        .answers
        .forEach((other, theirs) -> {
          if (!theirs.equals(answer)) {
            report.violated(
                AGREED,
                action.timeNs(),
                List.copyOf(new TreeSet<>(List.of(other, action.robot()))),
                String.format(
                    "%s ended with '%s', %s with '%s'", other, theirs, action.robot(), answer));
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
    SearchFact.Assigned duty = latestDuty();
    for (RobotId robot : search().robots) {
      boolean hasRoom = duty.rooms().containsKey(robot);
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

  /** What the leader of the latest term has assigned, if it is up and no robot has ended. */
  private SearchFact.Assigned latestDuty() {
    return search().duties.entrySet().stream()
        .max(Comparator.comparingLong(told -> told.getValue().term()))
        .filter(told -> faults.isUp(told.getKey()) && search().answers.isEmpty())
        .map(Map.Entry::getValue)
        .orElse(SearchFact.Assigned.NONE);
  }
}

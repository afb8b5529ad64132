package org.starl.apps.search.spec;

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
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;

/** {@code agreed} and {@code ended}: all robots end, with one answer. */
final class Ends implements Monitor {

  private static final String AGREED = "agreed";
  private static final String ENDED = "ended";

  private final Within<RobotId> within;
  private final FaultState circumstances = new FaultState();
  private final SortedMap<RobotId, String> answers = new TreeMap<>();
  private final Set<RobotId> robots = new TreeSet<>();

  Ends(long boundNs) {
    within = new Within<>(boundNs);
  }

  @Override
  public List<String> lemmas() {
    return List.of(AGREED, ENDED);
  }

  @Override
  public String description(String lemma) {
    return switch (lemma) {
      case AGREED -> "All robots that end have one answer.";
      case ENDED -> "Every robot that is up ends with an answer, within the bound.";
      default -> "";
    };
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    boolean isChanged = circumstances.observe(event);
    RobotId robot = event.robot();
    if (event instanceof Joined) {
      robots.add(robot);
      within.start(robot, event.timeNs());
    } else if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      within.stop(robot);
    } else if (event instanceof Fault fault
        && fault.name().equals(Fault.RESTART)
        && !answers.containsKey(robot)) {
      within.start(robot, event.timeNs());
    } else if (event instanceof Action action && SearchTrace.is(action, SearchTrace.ANSWER)) {
      ended(action, report);
    }
    if (isChanged) {
      within.assumeAll(circumstances.isFaultFree() && isMajorityUp(), event.timeNs());
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    within.expire(
        endNs,
        (robot, sinceNs, deadlineNs) -> {
          report.checked(ENDED);
          report.violated(
              ENDED, deadlineNs, List.of(robot), "has searched since " + sinceNs + " ns, no end");
        });
  }

  private boolean isMajorityUp() {
    return 2 * robots.stream().filter(circumstances::isUp).count() > robots.size();
  }

  private void ended(Action action, Report report) {
    if (within.stop(action.robot())) {
      report.checked(ENDED);
    }
    report.checked(AGREED);
    String answer = action.args().get(0);
    answers.forEach((other, theirs) -> {
      if (!theirs.equals(answer)) {
        report.violated(
            AGREED,
            action.timeNs(),
            List.copyOf(new TreeSet<>(List.of(other, action.robot()))),
            other + " ended with '" + theirs + "', " + action.robot() + " with '" + answer + "'");
      }
    });
    answers.put(action.robot(), answer);
  }
}

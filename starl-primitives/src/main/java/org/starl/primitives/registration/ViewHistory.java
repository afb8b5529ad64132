package org.starl.primitives.registration;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.ProcessId;
import org.starl.RobotId;
import org.starl.primitives.membership.View;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent.Variable;

/**
 * The one history of views that all robots of an instance must share, as far as any has shown it.
 * Numbers may be missing, and may come in any order.
 */
final class ViewHistory {

  private final String source;
  private final TreeMap<Long, View> views = new TreeMap<>();
  private final Map<ProcessId, Long> admittedBy = new TreeMap<>();
  private final Set<ProcessId> asked = new TreeSet<>();
  private final Map<RobotId, ProcessId> latestAsked = new TreeMap<>();
  private final Set<ProcessId> mayLeave = new TreeSet<>();

  ViewHistory(String source) {
    this.source = source;
  }

  /** Who stands in the deployment's own view need not have asked. */
  void isGiven(View first) {
    asked.addAll(first.ids());
  }

  /** An id counts only by its own robot's word. */
  void asked(RobotId robot, ProcessId id) {
    if (id.robot().equals(robot)) {
      asked.add(id);
      latestAsked.put(robot, id);
    }
  }

  void mayLeave(RobotId robot, ProcessId id) {
    if (id.robot().equals(robot)) {
      mayLeave.add(id);
    }
  }

  @Nullable ProcessId latestAsked(RobotId robot) {
    return latestAsked.get(robot);
  }

  void learned(Variable event, View view, Report report) {
    if (view.number() == 0) {
      return;
    }
    report.checked(RegistrationSpec.AGREEMENT);
    View known = views.putIfAbsent(view.number(), view);
    if (known != null) {
      if (!known.equals(view)) {
        violated(RegistrationSpec.AGREEMENT, event, report, view + " here, elsewhere " + known);
      }
      return;
    }
    Map.Entry<Long, View> before = views.lowerEntry(view.number());
    Map.Entry<Long, View> after = views.higherEntry(view.number());
    if (before != null) {
      follows(event, before.getValue(), view, report);
    }
    if (after != null) {
      follows(event, view, after.getValue(), report);
    }
    entriesAreSound(event, view, report);
  }

  /** The list that the app sees is that of the view of the same number. */
  void shown(Variable event, Report report) {
    String text = event.value();
    int colon = text.indexOf(':');
    if (colon < 0) {
      return;
    }
    report.checked(RegistrationSpec.AGREEMENT);
    View view = views.get(Long.parseLong(text.substring(0, colon)));
    if (view == null
        || !new RList.Agreed(view.participants(), view.number()).toString().equals(text)) {
      violated(RegistrationSpec.AGREEMENT, event, report, "rList " + text + ", but view " + view);
    }
  }

  private void follows(Variable event, View before, View after, Report report) {
    report.checked(RegistrationSpec.KEEPS);
    for (ProcessId id : before.ids()) {
      if (!after.contains(id) && !mayLeave.contains(id)) {
        violated(
            RegistrationSpec.KEEPS,
            event,
            report,
            after + " lacks " + id + ", listed in " + before);
      }
    }
    report.checked(RegistrationSpec.FRESH);
    for (ProcessId id : after.ids()) {
      if (after.admittedBy(id) <= before.number() && !before.contains(id)) {
        violated(
            RegistrationSpec.FRESH,
            event,
            report,
            after + " has " + id + " again, after " + before);
      }
    }
  }

  private void entriesAreSound(Variable event, View view, Report report) {
    report.checked(RegistrationSpec.SOUNDNESS);
    report.checked(RegistrationSpec.FRESH);
    for (ProcessId id : view.ids()) {
      if (!asked.contains(id)) {
        violated(
            RegistrationSpec.SOUNDNESS, event, report, view + " lists " + id + ", who never asked");
      }
      long by = admittedBy.computeIfAbsent(id, view::admittedBy);
      if (by != view.admittedBy(id)) {
        violated(
            RegistrationSpec.FRESH,
            event,
            report,
            view + ": view " + by + " let in " + id + " before");
      }
    }
  }

  private void violated(String lemma, Variable event, Report report, String detail) {
    report.violated(lemma, event.timeNs(), List.of(event.robot()), source + ": " + detail);
  }
}

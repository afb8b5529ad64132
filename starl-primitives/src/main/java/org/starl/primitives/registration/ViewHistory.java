package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Variable;

/**
 * The history of views of one registration, as its robots show it in the trace: it must be the same
 * for all robots. Numbers may be missing, and may come in any order.
 */
final class ViewHistory {

  /** Older views are forgotten and not compared: no robot is so far behind, and runs may be long. */
  private static final int KEPT_VIEWS = 256;

  private final Instance source;
  private final TreeMap<Long, View> views = new TreeMap<>();
  private final Map<ProcessId, Long> admittedBy = new TreeMap<>();
  private final Set<ProcessId> asked = new TreeSet<>();
  private final Map<RobotId, ProcessId> latestAsked = new TreeMap<>();
  private final Set<ProcessId> mayLeave = new TreeSet<>();
  private final Map<ProcessId, List<Confinement>> confined = new TreeMap<>();

  private List<RobotId> acceptors = List.of();

  ViewHistory(Instance source) {
    this.source = source;
  }

  /** The latest view that any robot has learned. */
  View latest() {
    return views.isEmpty() ? View.NONE : views.lastEntry().getValue();
  }

  /** The robots that vote, or none if the trace has not told yet. */
  List<RobotId> acceptors() {
    return acceptors;
  }

  void vote(List<RobotId> robots) {
    if (acceptors.isEmpty()) {
      acceptors = robots;
    }
  }

  /** Counts only if {@code id} is of {@code robot}. */
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

  /** {@code robot} proposes {@code confinement}. */
  void mayBeConfined(RobotId robot, Confinement confinement) {
    if (confinement.isSaidBy(robot)) {
      confined.computeIfAbsent(confinement.who(), id -> new ArrayList<>()).add(confinement);
    }
  }

  @Nullable ProcessId latestAsked(RobotId robot) {
    return latestAsked.get(robot);
  }

  /** The ids under which the robot has asked, of all its starts. */
  Set<ProcessId> askedBy(RobotId robot) {
    Set<ProcessId> ids = new TreeSet<>(asked);
    ids.removeIf(id -> !id.robot().equals(robot));
    return ids;
  }

  void learned(Variable event, View view, Report report) {
    if (view.number() == 0 || isForgotten(view.number())) {
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
    if (views.size() > KEPT_VIEWS) {
      views.pollFirstEntry();
    }
  }

  private boolean isForgotten(long number) {
    return views.size() >= KEPT_VIEWS && number < views.firstKey();
  }

  private void follows(Variable event, View before, View after, Report report) {
    report.checked(RegistrationSpec.KEEPS);
    for (ProcessId id : before.mentioned()) {
      String wrong = after.contains(id) || mayLeave.contains(id) ? "" : loss(id, before, after);
      if (!wrong.isEmpty()) {
        violated(RegistrationSpec.KEEPS, event, report, after + " after " + before + ": " + wrong);
      }
    }
    report.checked(RegistrationSpec.FRESH);
    for (ProcessId id : after.mentioned()) {
      View.Ghost ghost = after.ghost(id);
      long by = ghost == null ? after.admittedBy(id) : ghost.admittedBy();
      boolean isBack = ghost == null ? !before.contains(id) : !before.mentions(id);
      if (by <= before.number() && isBack) {
        violated(
            RegistrationSpec.FRESH,
            event,
            report,
            after + " has " + id + " again, after " + before);
      }
    }
  }

  /** The fault in how {@code after} treats {@code id}, which has not left; empty if there is none. */
  private String loss(ProcessId id, View before, View after) {
    View.Ghost was = before.ghost(id);
    View.Ghost is = after.ghost(id);
    SortedSet<String> left = is == null ? Sections.NONE : is.sections();
    if (was != null && left.equals(was.sections())) {
      return "";
    }
    if (was != null && !was.sections().containsAll(left)) {
      return id + " is fenced for more sections than before";
    }
    SortedSet<String> vouched = was == null ? null : was.sections();
    boolean isVouchedFor = after.number() > before.number() + 1;
    for (Confinement each : confined.getOrDefault(id, List.of())) {
      vouched = vouched == null ? each.sections() : Sections.common(vouched, each.sections());
      isVouchedFor |= each.hasFencersIn(before) && each.hasFencersIn(after);
    }
    if (vouched == null) {
      return id + " is missing";
    }
    if (!left.containsAll(vouched)) {
      return id + " may hold " + vouched;
    }
    return isVouchedFor ? "" : "no fencer of " + id + " is in both views";
  }

  private void entriesAreSound(Variable event, View view, Report report) {
    report.checked(RegistrationSpec.SOUNDNESS);
    report.checked(RegistrationSpec.FRESH);
    for (ProcessId id : view.mentioned()) {
      if (!asked.contains(id)) {
        violated(
            RegistrationSpec.SOUNDNESS,
            event,
            report,
            view + " lists " + id + ", which never asked");
      }
      View.Ghost ghost = view.ghost(id);
      long said = ghost == null ? view.admittedBy(id) : ghost.admittedBy();
      long by = admittedBy.computeIfAbsent(id, first -> said);
      if (by != said) {
        violated(
            RegistrationSpec.FRESH,
            event,
            report,
            view + ": " + id + " was admitted by view " + by);
      }
    }
  }

  private void violated(String lemma, Variable event, Report report, String detail) {
    report.violated(lemma, event.timeNs(), List.of(event.robot()), source + ": " + detail);
  }
}

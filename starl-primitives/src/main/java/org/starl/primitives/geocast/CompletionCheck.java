package org.starl.primitives.geocast;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.FlagCheck;
import org.starl.spec.Monitor.Report;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Variable;

/**
 * Checks that receivers acknowledge at once, and that a sender's {@code Gcastflag} is true exactly when each of its messages
 * is acknowledged by all others, or its interval is over.
 */
final class CompletionCheck {

  /** The time by which a copy may be late: a robot may compute meanwhile. */
  private static final long LATE_NS = 50_000_000;

  /** The time by which a copy may be early: a clock that drifts rounds what is due. */
  private static final long ROUNDED_NS = 1_000;

  /** A message of one program that is not complete, and who has acknowledged it. */
  private record Message(
      GeocastId id, long startNs, long deadlineNs, Set<RobotId> acknowledged, Repetition next) {}

  /** When the next copy is due, and the wait for it. */
  private static final class Repetition {
    private long waitNs;
    private long dueNs;

    private void after(long nowNs, long newWaitNs) {
      waitNs = newWaitNs;
      dueNs = nowNs + newWaitNs;
    }
  }

  private final GeocastSettings settings;
  private final FaultState faults;
  private final TellCheck answers = new TellCheck(GeocastSpec.ANSWERED);
  private final FlagCheck<Boolean> flag =
      new FlagCheck<>(GeocastFact.GCASTFLAG, GeocastSpec.GCASTFLAG);
  // The deployment is among all robots, and has those that take part.
  private final Set<RobotId> robots = new TreeSet<>();
  private final Map<Instance, Set<RobotId>> participants = new LinkedHashMap<>();
  private final Set<RobotId> crashed = new TreeSet<>();
  private final Map<ProcessKey, Map<GeocastId, Message>> messages = new LinkedHashMap<>();
  private long nowNs;

  // Until then some fault was active: a robot that computes repeats its copies late.
  private long faultyUntilNs = Long.MIN_VALUE;

  CompletionCheck(GeocastSettings settings, FaultState faults) {
    this.faults = faults;
    this.settings = settings;
    answers.begin();
  }

  /** Sees every event, before the other methods. */
  void observe(TraceEvent event, Report report) {
    nowNs = event.timeNs();
    faultyUntilNs = faults.isFaultFree() ? faultyUntilNs : nowNs;
    answers.observe(event, report);
    flag.observe(event, report);
    switch (event) {
      case Fault fault when fault.name().equals(Fault.CRASH) -> {
        crashed.add(fault.robot());
        messages.keySet().removeIf(key -> key.robot().equals(fault.robot()));
      }
      case Joined joined -> robots.add(joined.robot());
      case Action action -> acted(action, report);
      case Delivered got when got.message() instanceof GeocastMessage.Ack<?> ack ->
          acknowledged(got, ack.id(), report);
      case Variable variable -> flag.shows(variable, report);
      default -> {}
    }
  }

  private void acted(Action action, Report report) {
    switch (action.fact()) {
      case GeocastFact.Opened opened ->
          participants.computeIfAbsent(action.source(), any -> new TreeSet<>()).add(action.robot());
      case GeocastFact.do_geocast f -> starts(action, f.m(), f.bound(), report);
      case GeocastFact.BCast f -> starts(action, f.m(), f.bound(), report);
      case GeocastFact.copy f -> repeats(action, f.m(), report);
      default -> {}
    }
  }

  private void repeats(Action action, GeocastId id, Report report) {
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    Message message = messages.getOrDefault(key, Map.of()).get(id);
    checkRepeated(key, report);
    if (message != null) {
      long waitNs = message.next.waitNs;
      if (nowNs < message.next.dueNs - ROUNDED_NS
          && message.next.dueNs < message.deadlineNs
          && faults.isClockRight(action.robot(), message.next.dueNs - waitNs)) {
        String detail = key.source() + ": repeats " + id + " before " + waitNs + " ns";
        report.violated(GeocastSpec.REPEATED, nowNs, List.of(key.robot()), detail);
      }
      message.next.after(
          nowNs, waitNs == 0 ? settings.firstResendNs() : settings.nextResendNs(waitNs));
    }
  }

  /** A sender repeats each message that some participant has not acknowledged. */
  private void checkRepeated(ProcessKey key, Report report) {
    Set<RobotId> receivers = participants.getOrDefault(key.source(), Set.of());
    for (Message m : messages.getOrDefault(key, Map.of()).values()) {
      long dueNs = m.next.dueNs + LATE_NS;
      report.checked(GeocastSpec.REPEATED);
      if (m.next.waitNs > 0
          && nowNs > dueNs
          && dueNs < m.deadlineNs
          && !isBy(receivers, m)
          && m.next.dueNs - m.next.waitNs > faultyUntilNs) {
        m.next.dueNs = m.deadlineNs;
        String detail =
            key.source() + ": has not repeated " + m.id + " for " + m.next.waitNs + " ns";
        report.violated(GeocastSpec.REPEATED, nowNs, List.of(key.robot()), detail);
      }
    }
  }

  private void starts(Action action, GeocastId id, long boundNs, Report report) {
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    checkRepeated(key, report);
    messages
        .computeIfAbsent(key, any -> new LinkedHashMap<>())
        .put(
            id,
            new Message(
                id,
                nowNs,
                nowNs + boundNs,
                new TreeSet<>(Set.of(action.robot())),
                new Repetition()));
    says(key, action, report);
  }

  private void acknowledged(Delivered got, GeocastId id, Report report) {
    ProcessKey key = new ProcessKey(got.channel(), got.robot());
    Map<GeocastId, Message> own = messages.get(key);
    Message message = own == null ? null : own.get(id);
    checkRepeated(key, report);
    if (own != null && message != null && message.acknowledged().add(got.from())) {
      own.values().removeIf(other -> other.deadlineNs() < nowNs);
      says(key, got, report);
    }
  }

  private void says(ProcessKey key, TraceEvent event, Report report) {
    Map<GeocastId, Message> own = messages.getOrDefault(key, Map.of());
    flag.says(
        key,
        event,
        isComplete ->
            isComplete
                ? own.values().stream()
                    .noneMatch(m ->
                        isOpen(key.robot(), m)
                            && !isBy(participants.getOrDefault(key.source(), Set.of()), m))
                : own.isEmpty()
                    || robots.size() == 1 // nobody acknowledges
                    || own.values().stream().anyMatch(m -> !isBy(robots, m)),
        report);
  }

  /** Whether the interval is certainly not over, by the sender's clock. */
  private boolean isOpen(RobotId sender, Message message) {
    return nowNs < message.deadlineNs() && faults.isClockRight(sender, message.startNs());
  }

  private boolean isBy(Set<RobotId> receivers, Message message) {
    return !settings.openMembership() && message.acknowledged().containsAll(receivers);
  }

  /** The robot has the message, and gets a copy of it: it acknowledges that in this step. */
  void mustAnswer(TraceEvent event, CastRecord cast) {
    if (!crashed.contains(event.robot())) {
      answers.owes(
          event,
          cast.origin.name(),
          "that it has " + cast.id,
          told -> told instanceof GeocastMessage.Ack<?> ack && ack.id().equals(cast.id));
    }
  }
}

package org.starl.primitives.registration;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;

/**
 * Checks that a robot which hears of a newer view shows no list, until it learns a view as new or the time of a rumour
 * is over.
 */
final class RumourCheck {

  /** What one program knows, and shows. */
  private static final class Known {
    private long view;
    private long rumoured;
    private long hiddenUntilNs = Long.MIN_VALUE;
    private long sinceNs;
    private boolean isListShown;

    /** Whether the list must be hidden. */
    boolean isHidden(long nowNs) {
      return rumoured > view && nowNs < hiddenUntilNs;
    }
  }

  private final long nullNs;
  private final FaultState faults;
  private final Map<ProcessKey, Known> programs = new LinkedHashMap<>();
  private final Set<ProcessKey> due = new LinkedHashSet<>();
  private long nowNs;

  RumourCheck(long nullNs, FaultState faults) {
    this.nullNs = nullNs;
    this.faults = faults;
  }

  /** Sees every event, before the other methods. */
  void observe(TraceEvent event, Report report) {
    if (event.timeNs() != nowNs) {
      due.forEach(key -> judge(key, report));
      due.clear();
      nowNs = event.timeNs();
    }
    if (event instanceof Delivered got && RegistrationFact.isRegistration(got.channel())) {
      ProcessKey key = new ProcessKey(got.channel(), got.robot());
      switch (got.message()) {
        case Prepare m -> rumour(key, m.number());
        case Accept m -> rumour(key, m.number());
        default -> {}
      }
    }
  }

  private Known known(ProcessKey key) {
    return programs.computeIfAbsent(key, any -> new Known());
  }

  private void rumour(ProcessKey key, long number) {
    Known known = programs.get(key);
    if (known == null) {
      return; // no program that shows a list
    }
    boolean isNew = known.rumoured <= known.view;
    known.rumoured = Math.max(known.rumoured, number);
    if (isNew && known.rumoured > known.view) {
      known.sinceNs = nowNs;
      known.hiddenUntilNs = nowNs + nullNs;
    }
    due.add(key);
  }

  /** The robot learns this view; number 0 when its program starts. */
  void learns(ProcessKey key, long view) {
    Known known = known(key);
    boolean mayHaveExpired = nowNs >= known.hiddenUntilNs;
    if (view == 0) {
      programs.put(key, new Known());
    } else {
      known.view = view;
      known.hiddenUntilNs = mayHaveExpired ? Long.MIN_VALUE : known.hiddenUntilNs;
    }
    due.add(key);
  }

  void shows(ProcessKey key, RList list) {
    known(key).isListShown = list.isAgreed();
    due.add(key);
  }

  void ended(RobotId robot) {
    programs.keySet().removeIf(key -> key.robot().equals(robot));
    due.removeIf(key -> key.robot().equals(robot));
  }

  private void judge(ProcessKey key, Report report) {
    Known known = programs.get(key);
    if (known == null
        || !known.isHidden(nowNs)
        || !faults.isClockRight(key.robot(), known.sinceNs)) {
      return;
    }
    report.checked(RegistrationSpec.RUMOUR);
    if (known.isListShown) {
      report.violated(
          RegistrationSpec.RUMOUR,
          nowNs,
          List.of(key.robot()),
          key.source()
              + ": shows the list of view "
              + known.view
              + ", and has heard of "
              + known.rumoured);
    }
  }
}

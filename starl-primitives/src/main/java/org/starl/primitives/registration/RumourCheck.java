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
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * Checks that a robot which proposes a newer view, or hears that one is proposed, hides its list in the same step. Only the
 * first rumour after each view is checked: the time of one rumour may be over when the next one comes.
 */
final class RumourCheck {

  /** What one program knows, and shows. */
  private static final class Known {
    private long view;
    private long rumoured;
    private long proposed;
    private long askedIn; // the last number that may admit its id
    private boolean isJoining;
    private boolean isListShown;
  }

  private final Map<ProcessKey, Known> programs = new LinkedHashMap<>();
  private final Set<ProcessKey> due = new LinkedHashSet<>();
  private long nowNs;
  private boolean isOn;

  /** Checks from now on; nothing before. */
  void begin() {
    isOn = true;
  }

  /** Sees every event, before the other methods. */
  void observe(TraceEvent event, Report report) {
    if (event.timeNs() != nowNs) {
      due.forEach(key -> judge(key, report));
      due.clear();
      nowNs = event.timeNs();
    }
    switch (event) {
      case Delivered got when got.message() instanceof Prepare m ->
          rumour(new ProcessKey(got.channel(), got.robot()), m.number(), false);
      case Delivered got when got.message() instanceof Accept m ->
          rumour(new ProcessKey(got.channel(), got.robot()), m.number(), false);
      case Sent sent when sent.message() instanceof Prepare m ->
          rumour(new ProcessKey(sent.channel(), sent.robot()), m.number(), true);
      default -> {}
    }
  }

  private void rumour(ProcessKey key, long number, boolean isOwn) {
    Known known = programs.get(key);
    if (isOn && known != null && number > known.view) {
      if (known.rumoured <= known.view) {
        due.add(key);
      }
      known.rumoured = Math.max(known.rumoured, number);
      if (isOwn) {
        known.proposed = number;
        known.askedIn = known.isJoining ? number : 0;
      }
    }
  }

  /** The robot learns this view; number 0 when its program starts. */
  void learns(ProcessKey key, long view) {
    Known known = view == 0 ? new Known() : known(key);
    known.view = view;
    programs.put(key, known);
  }

  void shows(ProcessKey key, RList list) {
    known(key).isListShown = list.isAgreed();
  }

  /** The robot asks to be on a list, until {@link #joins} says that it is. */
  void joins(ProcessKey key, boolean isJoining) {
    known(key).isJoining = isJoining;
    known(key).askedIn = 0;
  }

  /** The last number that may admit the robot's id; 0 for none. A later view tells that it may have missed it. */
  long askedIn(ProcessKey key) {
    return known(key).askedIn;
  }

  boolean isListShown(ProcessKey key) {
    return known(key).isListShown;
  }

  /** Whether the robot has heard of a newer view than it knows, or proposes one; true if that is not checked. */
  boolean mayHide(ProcessKey key) {
    return !isOn || known(key).rumoured > known(key).view;
  }

  /** Whether it has heard of a newer view, and proposed none. */
  boolean isBehind(ProcessKey key) {
    return mayHide(key) && known(key).proposed <= known(key).view;
  }

  private Known known(ProcessKey key) {
    return programs.computeIfAbsent(key, any -> new Known());
  }

  void ended(RobotId robot) {
    programs.keySet().removeIf(key -> key.robot().equals(robot));
    due.removeIf(key -> key.robot().equals(robot));
  }

  private void judge(ProcessKey key, Report report) {
    Known known = programs.get(key);
    if (known != null) {
      report.checked(RegistrationSpec.RUMOUR);
      if (known.isListShown && known.rumoured > known.view) {
        report.violated(
            RegistrationSpec.RUMOUR,
            nowNs,
            List.of(key.robot()),
            String.format(
                "%s: shows the list of view %s, and has heard of %s",
                key.source(), known.view, known.rumoured));
      }
    }
  }
}

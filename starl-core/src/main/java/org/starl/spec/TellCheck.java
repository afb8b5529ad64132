package org.starl.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Sent;

/**
 * Checks, in a trace, that a robot which must tell another one something sends it in the same step: a
 * lemma of each primitive whose robots help those that are behind. No time passes during a step, so all
 * that it sends has one time.
 */
public final class TellCheck {

  private final String lemma;
  private final List<Duty> duties = new ArrayList<>();
  private final List<Sent> sent = new ArrayList<>();
  private long atNs;
  private boolean isOn;

  /** What the event's robot must send to the robot {@code to} at the event's time. */
  private record Duty(TraceEvent event, String to, String what, Predicate<Object> accepts) {}

  /** Checks nothing before {@link #begin}. */
  public TellCheck(String lemma) {
    this.lemma = lemma;
  }

  /** Checks from now on. */
  public void begin() {
    isOn = true;
  }

  /** Sees each event of the run; duties of an event may be added before it or after it. */
  public void observe(TraceEvent event, Report report) {
    if (event.timeNs() != atNs) {
      duties.removeIf(duty -> isOver(duty, event.timeNs(), report));
      sent.clear();
      atNs = event.timeNs();
    }
    if (isOn && event instanceof Sent message) {
      sent.add(message);
    }
  }

  /**
   * The event's robot must tell {@code to}, in this step.
   *
   * @param what the message that is due, for the violation's text
   * @param accepts whether a message is that one
   */
  public void owes(TraceEvent event, String to, String what, Predicate<Object> accepts) {
    if (isOn) {
      duties.add(new Duty(event, to, what, accepts));
    }
  }

  private boolean isOver(Duty duty, long nowNs, Report report) {
    boolean isOver = duty.event.timeNs() != nowNs;
    if (isOver) {
      judge(duty, report);
    }
    return isOver;
  }

  private void judge(Duty duty, Report report) {
    report.checked(lemma);
    TraceEvent event = duty.event;
    boolean isDone =
        sent.stream()
            .anyMatch(message ->
                message.robot().equals(event.robot())
                    && message.to().equals(duty.to)
                    && duty.accepts.test(message.message()));
    if (!isDone) {
      String detail = "does not tell " + duty.to + ": " + duty.what;
      report.violated(lemma, event.timeNs(), List.of(event.robot()), detail);
    }
  }
}

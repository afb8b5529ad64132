package org.starl.robot;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.starl.id.RobotId;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;

/**
 * Checks the app's specifications over the events of one robot during its run: only the lemmas that
 * one robot can violate alone ({@link Monitor#perRobotLemmas}). The monitors get no measured
 * positions: an error of measurement must not stop a robot. Strand only.
 */
public final class LocalSpecs {

  private final List<Monitor> monitors = new ArrayList<>();
  private final List<String> lemmas = new ArrayList<>();
  private final long startNs;
  private final Consumer<Violation> onViolation;

  /**
   * @param makers of the app's monitors
   * @param startNs the trace's time 0, on the clock of the events
   * @param onViolation takes violations, with times of the trace
   */
  public LocalSpecs(
      List<? extends Supplier<? extends Monitor>> makers,
      long startNs,
      Consumer<Violation> onViolation) {
    this.startNs = startNs;
    this.onViolation = onViolation;
    for (Monitor monitor : Monitors.of(makers).monitors()) {
      if (!monitor.perRobotLemmas().isEmpty()) {
        monitors.add(monitor);
        lemmas.addAll(monitor.perRobotLemmas());
      }
    }
    // In real time progress is not required.
    show(Fault.realTime(startNs));
  }

  /** The lemmas that are checked. */
  public List<String> lemmas() {
    return Collections.unmodifiableList(lemmas);
  }

  /** The next event of this robot, with its time on the clock. */
  public void observed(TraceEvent event) {
    if (!(event instanceof Joined || event instanceof Moved || event instanceof Left)) {
      show(event);
    }
  }

  private void show(TraceEvent event) {
    for (Monitor monitor : monitors) {
      monitor.observe(event, new Own(monitor.perRobotLemmas()));
    }
  }

  /** Reports the violations of these lemmas. */
  private final class Own implements Monitor.Report {
    private final List<String> own;

    Own(List<String> own) {
      this.own = own;
    }

    @Override
    public void checked(String lemma) {
      // Only violations count.
    }

    @Override
    public void violated(String lemma, long timeNs, List<RobotId> robots, String detail) {
      if (own.contains(lemma)) {
        onViolation.accept(new Violation(lemma, Math.max(0, timeNs - startNs), robots, detail));
      }
    }
  }
}

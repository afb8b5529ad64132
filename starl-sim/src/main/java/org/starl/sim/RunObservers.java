package org.starl.sim;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.starl.id.RobotId;
import org.starl.platform.LogSink;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceSink;

/** The monitors of a run or a trace, then its observers, in the order given. */
public final class RunObservers implements TraceSink {

  private final Monitors monitors;
  private final List<SimObserver> observers;
  private final Function<SpecReport.Violation, Diagnosis> diagnose;
  private final Map<SpecReport.Violation, Diagnosis> diagnoses = new LinkedHashMap<>();
  private final Set<String> diagnosed = new TreeSet<>();

  /**
   * @param diagnose tells what the robots of a violation do now, and why the run does not go on
   */
  public RunObservers(
      Monitors monitors,
      List<SimObserver> observers,
      Function<SpecReport.Violation, Diagnosis> diagnose) {
    this.monitors = monitors;
    this.diagnose = diagnose;
    this.observers = List.copyOf(observers);
  }

  @Override
  public boolean isOn() {
    return !monitors.monitors().isEmpty() || !observers.isEmpty();
  }

  @Override
  public void record(TraceEvent event) {
    monitors.observe(event);
    for (int i = 0; i < observers.size(); i++) {
      observers.get(i).observed(event);
    }
    reportViolations();
  }

  private void reportViolations() {
    for (SpecReport.Violation violation : monitors.newViolations()) {
      if (diagnosed.add(violation.lemma())) {
        diagnoses.put(violation, diagnose.apply(violation));
      }
      observers.forEach(observer -> observer.violated(violation));
    }
  }

  /** The first violation of each lemma, and the diagnosis when it was noticed. */
  Map<SpecReport.Violation, Diagnosis> diagnoses() {
    return diagnoses;
  }

  public void started(TraceHeader header) {
    observers.forEach(observer -> observer.started(header));
  }

  public SpecReport endSpecifications(long endNs) {
    monitors.finish(endNs);
    reportViolations();
    return monitors.report();
  }

  /** The first violation, as the end of an error message; empty if there is none. */
  String firstViolation() {
    List<SpecReport.Violation> violations = monitors.report().violations();
    return violations.isEmpty() ? "" : "; before that, " + violations.get(0);
  }

  public void finished(SimResult result) {
    observers.forEach(observer -> observer.finished(result));
  }

  /** Receives the log lines of {@code robot}. */
  LogSink logOf(RobotId robot) {
    return (timeNs, level, tag, line) ->
        observers.forEach(observer -> observer.logged(timeNs, robot, level, tag, line));
  }
}

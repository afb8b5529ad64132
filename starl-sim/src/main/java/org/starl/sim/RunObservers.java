package org.starl.sim;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
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
  private final FailureFinder finder;
  private @Nullable Failure failure;

  /**
   * @param diagnose tells what the robots of a violation do now, and why the run does not go on
   * @param commands that repeat the run and shrink it
   */
  public RunObservers(
      Monitors monitors,
      List<SimObserver> observers,
      Function<SpecReport.Violation, Diagnosis> diagnose,
      Supplier<List<String>> commands) {
    this.monitors = monitors;
    this.diagnose = diagnose;
    finder = new FailureFinder(commands);
    this.observers = List.copyOf(observers);
  }

  @Override
  public boolean isOn() {
    return !monitors.monitors().isEmpty() || !observers.isEmpty();
  }

  @Override
  public void record(TraceEvent event) {
    monitors.observe(event);
    finder.observe(event);
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
      if (failure == null) {
        String sentence = monitors.report().description(violation.lemma());
        Diagnosis diagnosis = diagnoses.getOrDefault(violation, Diagnosis.NONE);
        wentWrong(finder.violated(violation, sentence, diagnosis));
      }
    }
  }

  private void wentWrong(Failure found) {
    failure = found;
    observers.forEach(observer -> observer.wentWrong(found));
  }

  /**
   * What went wrong in the run that ends now; null if nothing did.
   *
   * @param unfinished the robots whose apps have not ended
   */
  public @Nullable Failure failure(List<RobotId> unfinished, Diagnosis diagnosis, long endNs) {
    if (failure == null && !unfinished.isEmpty()) {
      wentWrong(finder.unfinished(unfinished, diagnosis, endNs));
    }
    return failure;
  }

  /**
   * Tells that an error ends the run.
   *
   * @param robots in whose programs it is
   */
  void failed(List<RobotId> robots, String headline, long atNs) {
    if (failure == null) {
      wentWrong(finder.failed(robots, headline, atNs));
    }
  }

  /** The faults injected so far, in the order of their beginnings. */
  public List<InjectedFault> faults() {
    return finder.faults();
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

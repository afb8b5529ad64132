package org.starl.spec;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;

/** Several monitors on one run, and their results. Pass every event in order, then the end. */
public final class Monitors {

  private final List<Monitor> monitors;
  private final SpecReport report;
  private boolean finished;
  private int told;

  /** Exactly these monitors, without companions. */
  public Monitors(List<? extends Monitor> monitors) {
    this(monitors, Specs.ALL);
  }

  private Monitors(List<? extends Monitor> all, Specs specs) {
    List<Monitor> installed = new ArrayList<>(all);
    report = new SpecReport(specs);
    if (specs == Specs.SAFETY) {
      all.forEach(monitor -> report.leaveOut(monitor.progressLemmas()));
      installed.removeIf(monitor -> report.leftOut().containsAll(monitor.lemmas()));
    }
    monitors = List.copyOf(installed);
    for (Monitor monitor : monitors) {
      report.expect(monitor.lemmas());
      monitor.lemmas().forEach(lemma -> report.describe(lemma, monitor.description(lemma)));
      report.except(monitor.exceptions());
      monitor.inapplicable().forEach(report::exempt);
    }
  }

  /**
   * The monitors that {@code makers} create, followed by their {@link Monitor#companions} and those of
   * these, at most one of each class.
   */
  public static Monitors of(List<? extends Supplier<? extends Monitor>> makers) {
    return of(makers, Specs.ALL);
  }

  /** Those of {@link #of(List)} that check some of {@code specs}, and only these lemmas. */
  public static Monitors of(List<? extends Supplier<? extends Monitor>> makers, Specs specs) {
    if (specs == Specs.OFF) {
      return new Monitors(List.of(), specs);
    }
    List<Monitor> monitors = new ArrayList<>();
    makers.forEach(maker -> monitors.add(maker.get()));
    Set<Class<?>> classes = new LinkedHashSet<>();
    monitors.forEach(monitor -> classes.add(monitor.getClass()));
    // Those that are added have companions, too.
    for (int i = 0; i < monitors.size(); i++) {
      for (Monitor companion : monitors.get(i).companions()) {
        if (classes.add(companion.getClass())) {
          monitors.add(companion);
        }
      }
    }
    return new Monitors(monitors, specs);
  }

  /** All monitors. */
  public List<Monitor> monitors() {
    return monitors;
  }

  /** The lemmas of all monitors. */
  public List<String> lemmas() {
    List<String> lemmas = new ArrayList<>();
    for (Monitor monitor : monitors) {
      lemmas.addAll(monitor.lemmas());
    }
    return lemmas;
  }

  /**
   * Processes the next event.
   *
   * @throws IllegalStateException after {@link #finish}, or if a monitor throws: the message names
   *     the monitor and the event, since the event's cause, often an app, is not at fault
   */
  public void observe(TraceEvent event) {
    requireRunning();
    for (Monitor monitor : monitors) {
      try {
        monitor.observe(event, report);
      } catch (RuntimeException e) {
        throw failed(monitor, event.toString(), e);
      }
    }
  }

  /**
   * Processes the end of the run, once.
   *
   * @throws IllegalStateException the second time, or if a monitor throws: the message names it
   */
  public void finish(long endNs) {
    requireRunning();
    finished = true;
    for (Monitor monitor : monitors) {
      try {
        monitor.finish(endNs, report);
        monitor.inapplicable().forEach(report::exempt);
        monitor.inPart().forEach(report::inPart);
      } catch (RuntimeException e) {
        throw failed(monitor, "the end", e);
      }
    }
  }

  private static IllegalStateException failed(Monitor monitor, String at, RuntimeException why) {
    String name = monitor.getClass().getName();
    return new IllegalStateException("the monitor " + name + " failed at " + at + ": " + why, why);
  }

  /** The violations found since the last call. */
  public List<Violation> newViolations() {
    List<Violation> found = report.violations();
    if (found.size() == told) {
      return List.of();
    }
    List<Violation> latest = List.copyOf(found.subList(told, found.size()));
    told = found.size();
    return latest;
  }

  /** The results so far. */
  public SpecReport report() {
    return report;
  }

  private void requireRunning() {
    if (finished) {
      throw new IllegalStateException("these monitors have processed the end of the run already");
    }
  }
}

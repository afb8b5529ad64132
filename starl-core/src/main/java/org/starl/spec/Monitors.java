package org.starl.spec;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;

/** Several monitors over one run, and what they find. Feed it every event in order, then the end. */
public final class Monitors {

  private final List<Monitor> monitors;
  private final SpecReport report = new SpecReport();
  private boolean finished;
  private int told;

  /** These alone. */
  public Monitors(List<? extends Monitor> monitors) {
    this.monitors = List.copyOf(monitors);
    for (Monitor monitor : this.monitors) {
      report.expect(monitor.lemmas());
    }
  }

  /** Those who are made, and then their {@link Monitor#companions}, of each class one at most. */
  public static Monitors of(List<? extends Supplier<? extends Monitor>> makers) {
    List<Monitor> monitors = new ArrayList<>();
    makers.forEach(maker -> monitors.add(maker.get()));
    Set<Class<?>> classes = new LinkedHashSet<>();
    monitors.forEach(monitor -> classes.add(monitor.getClass()));
    for (Monitor monitor : List.copyOf(monitors)) {
      for (Monitor companion : monitor.companions()) {
        if (classes.add(companion.getClass())) {
          monitors.add(companion);
        }
      }
    }
    return new Monitors(monitors);
  }

  /** All of them. */
  public List<Monitor> all() {
    return monitors;
  }

  /** All lemmas, monitor by monitor. */
  public List<String> lemmas() {
    List<String> lemmas = new ArrayList<>();
    for (Monitor monitor : monitors) {
      lemmas.addAll(monitor.lemmas());
    }
    return lemmas;
  }

  /**
   * Sees the next event.
   *
   * @throws IllegalStateException after {@link #finish}
   */
  public void observe(TraceEvent event) {
    requireRunning();
    for (Monitor monitor : monitors) {
      monitor.observe(event, report);
    }
  }

  /**
   * Sees the end of the run, once.
   *
   * @throws IllegalStateException the second time
   */
  public void finish(long endNs) {
    requireRunning();
    finished = true;
    for (Monitor monitor : monitors) {
      monitor.finish(endNs, report);
    }
  }

  /** The violations that were found since this was asked last. */
  public List<Violation> news() {
    List<Violation> found = report.violations();
    if (found.size() == told) {
      return List.of();
    }
    List<Violation> news = List.copyOf(found.subList(told, found.size()));
    told = found.size();
    return news;
  }

  /** What was found so far. */
  public SpecReport report() {
    return report;
  }

  private void requireRunning() {
    if (finished) {
      throw new IllegalStateException("the run has ended already for these monitors");
    }
  }
}

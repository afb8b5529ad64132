package org.starl.spec;

import java.util.ArrayList;
import java.util.List;
import org.starl.trace.TraceEvent;

/** Several monitors over one run, and what they find. Feed it every event in order, then the end. */
public final class Monitors {

  private final List<Monitor> monitors;
  private final SpecReport report = new SpecReport();
  private boolean finished;

  public Monitors(List<? extends Monitor> monitors) {
    this.monitors = List.copyOf(monitors);
    for (Monitor monitor : this.monitors) {
      report.expect(monitor.lemmas());
    }
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

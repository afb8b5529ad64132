package org.starl.sim.replay;

import java.util.List;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/** Specifications that look at a trace, event by event; tells what is newly found. */
final class Checker {

  private final Monitors monitors;
  private int told;

  /**
   * @param monitors fresh ones
   */
  Checker(List<Monitor> monitors) {
    this.monitors = new Monitors(monitors);
  }

  /** The violations that the next event made known. */
  List<SpecReport.Violation> observe(TraceEvent event) {
    monitors.observe(event);
    return found();
  }

  /** Those that only the end of the run made known; once, after all events. */
  List<SpecReport.Violation> finish(long endNs) {
    monitors.finish(endNs);
    return found();
  }

  SpecReport report() {
    return monitors.report();
  }

  private List<SpecReport.Violation> found() {
    int found = report().found();
    if (found == told) {
      return List.of();
    }
    List<SpecReport.Violation> fresh = List.copyOf(report().violations().subList(told, found));
    told = found;
    return fresh;
  }
}

package org.starl.processes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.starl.sim.Blueprint;
import org.starl.sim.SimObserver;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * All robots' traces as one, in the order of their times. What one robot does in one action has one
 * time, and stays together.
 */
final class Merged {

  private final List<TraceEvent> events = new ArrayList<>();
  private long datagrams;
  private long bytes;

  Merged() {
    events.add(new Fault(0, Fault.WORLD, Fault.BEGIN, Fault.REAL_TIME));
  }

  void add(TraceEvent event) {
    events.add(event);
    if (event instanceof TraceEvent.Sent sent) {
      datagrams++;
      bytes += sent.bytes();
    }
  }

  long size() {
    return events.size();
  }

  /** Datagrams that were handed to radios. */
  long datagrams() {
    return datagrams;
  }

  /** Their lengths added up. */
  long bytes() {
    return bytes;
  }

  /** Shows all of it to the monitors and the observers of {@code blueprint}. */
  SpecReport show(Blueprint blueprint, long endNs) {
    events.sort(Comparator.comparingLong(TraceEvent::timeNs).thenComparing(TraceEvent::robot));
    List<Monitor> made = new ArrayList<>();
    blueprint.monitors().forEach(maker -> made.add(maker.get()));
    Monitors monitors = new Monitors(made);
    blueprint.observers().forEach(observer -> observer.started(blueprint.header()));
    for (TraceEvent event : events) {
      monitors.observe(event);
      for (SimObserver observer : blueprint.observers()) {
        observer.observed(event);
      }
    }
    monitors.finish(endNs);
    return monitors.report();
  }
}

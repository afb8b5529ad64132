package org.starl.processes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.starl.sim.Blueprint;
import org.starl.sim.SimObserver;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * All robots' traces as one, in the order of their times. What one robot does in one action has one
 * time, and stays together.
 */
public final class Merged {

  private final List<TraceEvent> events = new ArrayList<>();
  private long datagrams;
  private long bytes;

  /** Nothing yet, but that it was in real time: no progress is owed. */
  public Merged() {
    events.add(new Fault(0, Fault.WORLD, Fault.BEGIN, Fault.REAL_TIME));
  }

  public void add(TraceEvent event) {
    events.add(event);
    if (event instanceof TraceEvent.Sent sent) {
      datagrams++;
      bytes += sent.bytes();
    }
  }

  /** How many events there are. */
  public long size() {
    return events.size();
  }

  /** Datagrams that were handed to radios. */
  public long datagrams() {
    return datagrams;
  }

  /** Their lengths added up. */
  public long bytes() {
    return bytes;
  }

  /** Shows all of it to the monitors and the observers of {@code blueprint}. */
  SpecReport show(Blueprint blueprint, long endNs) {
    return show(blueprint, blueprint.observers(), endNs);
  }

  /** Shows all of it to fresh monitors of {@code blueprint}, and to these observers. */
  public SpecReport show(Blueprint blueprint, List<SimObserver> observers, long endNs) {
    events.sort(Comparator.comparingLong(TraceEvent::timeNs).thenComparing(TraceEvent::robot));
    Monitors monitors = Monitors.of(blueprint.monitors());
    observers.forEach(observer -> observer.started(blueprint.header()));
    for (TraceEvent event : events) {
      monitors.observe(event);
      for (SimObserver observer : observers) {
        observer.observed(event);
      }
    }
    monitors.finish(endNs);
    return monitors.report();
  }
}

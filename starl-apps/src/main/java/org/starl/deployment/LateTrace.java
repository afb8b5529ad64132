package org.starl.deployment;

import java.util.List;
import org.starl.platform.TraceSink;
import org.starl.processes.Outbox;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;

/**
 * A trace whose time 0 is not that of the clock: it begins when its process does. Those who observe the
 * robot for the scenario's director see its events on its strand, as it makes them.
 */
record LateTrace(Outbox trace, long startNs, List<SimObserver> observers) implements TraceSink {

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public void record(TraceEvent event) {
    trace.record(event.at(Math.max(0, event.timeNs() - startNs)));
    observers.forEach(observer -> observer.observed(event));
  }
}

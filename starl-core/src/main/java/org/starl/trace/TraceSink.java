package org.starl.trace;

/** Receives the run's events in the order in which they happen. */
public interface TraceSink {

  /** Whether events are recorded; if not, callers create no events. Constant during a run. */
  boolean isOn();

  void record(TraceEvent event);
}

package org.starl.trace;

/** Takes the run's events, in the order in which they happen. */
public interface TraceSink {

  /** Whether anybody listens; where not, callers make no event. Constant during a run. */
  boolean isOn();

  void record(TraceEvent event);
}

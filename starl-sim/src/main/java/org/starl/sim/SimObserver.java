package org.starl.sim;

import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Observes a run, as viewers, recorders, exporters, stories and trace files do. It receives every
 * event in order and has no effect on the run.
 */
public interface SimObserver {

  /** Before the first event. */
  default void started(TraceHeader header) {}

  /** Each event, in order. */
  default void observed(TraceEvent event) {}

  /** Each recorded violation, after the event that caused it has been observed. */
  default void violated(SpecReport.Violation violation) {}

  /**
   * The description of what went wrong: once in a bad run, after the first {@link #violated}, or,
   * without a violation, before {@link #finished}.
   */
  default void wentWrong(Failure failure) {}

  /** Each log line of a robot. */
  default void logged(long timeNs, RobotId robot, Level level, String tag, String line) {}

  /** After the last event; not called if an error ended the run. */
  default void finished(SimResult result) {}
}

package org.starl.robot.trace;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * Events of a robot's process, as actions of the source {@code process}: for a child's parent, and for
 * the merging of deployed robots' traces.
 */
public enum ProcessWord {
  /** The process has started: its process id. */
  HELLO,
  /** Its radio's port. */
  PORT,
  /** Its body waits for room at its start position. */
  WANTS_PLACE,
  /** It is alive: copies of datagrams so far, lost ones, the longest pause of its strand in ns. */
  ALIVE,
  /** Its app has ended: results. */
  FINISHED,
  /** It ends before its app: the awaited condition, then source, text and robots of each wait. */
  WAITS,
  /** A line for people: level, tag, line. */
  LOG,
  /** It ends because of a bug: the stack trace. */
  ERROR,
  /**
   * Its clock: the machine's name, the trace's time 0 on that machine's clock in ns, and the same in ns
   * since 2020 by that machine's date. First in a deployed robot's trace.
   */
  CLOCK;

  private static final String SOURCE = "process";

  public TraceEvent event(long timeNs, RobotId robot, List<String> args) {
    return new Action(timeNs, robot, SOURCE, name(), args);
  }

  /** Whether an event is one of these; {@link #valueOf} knows its name. */
  public static boolean isProcessEvent(TraceEvent event) {
    return event instanceof Action action && action.source().equals(SOURCE);
  }
}

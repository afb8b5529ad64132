package org.starl.robot.trace;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * What a robot's process tells of itself, as actions of the source {@code process}: a child its parent,
 * a deployed robot whoever merges its trace.
 */
public enum Word {
  /** It is there: its process's number. */
  HELLO,
  /** Its radio listens at this port. */
  PORT,
  /** Its body waits for its place on the floor. */
  WANTS_PLACE,
  /** It lives: copies of datagrams so far, those lost, the longest silence of its strand in ns. */
  ALIVE,
  /** Its app has come to its end: results. */
  FINISHED,
  /** A line for people: level, tag, line. */
  LOG,
  /** It ends by a bug: the stack trace. */
  ERROR,
  /**
   * Its clock: what the trace's time 0 is on the clock of a machine that it names, in ns, and in ns
   * since 2020 by that machine's date. First in a deployed robot's trace.
   */
  CLOCK;

  private static final String SOURCE = "process";

  public TraceEvent event(long timeNs, RobotId robot, List<String> args) {
    return new Action(timeNs, robot, SOURCE, name(), args);
  }

  /** Whether an event is one of these, whose name {@link #valueOf} knows. */
  public static boolean isOne(TraceEvent event) {
    return event instanceof Action action && action.source().equals(SOURCE);
  }
}

package org.starl.processes;

import java.util.List;
import org.starl.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** What a child tells its parent, as actions of the source {@code process}. */
enum Word {
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
  ERROR;

  private static final String SOURCE = "process";

  TraceEvent event(long timeNs, RobotId robot, List<String> args) {
    return new Action(timeNs, robot, SOURCE, name(), args);
  }

  static boolean isOne(TraceEvent event) {
    return event instanceof Action action && action.source().equals(SOURCE);
  }
}

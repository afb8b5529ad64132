package org.starl.sim.kernel;

import org.starl.time.Time;

/**
 * A robot's app, handler or timer threw an exception: a bug in the robot's program, which ends the
 * run. The cause is that exception.
 */
public final class RobotError extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final String strand;
  private final long timeNs;

  RobotError(String strand, long timeNs, Throwable cause) {
    super(strand + " at " + Time.text(timeNs, 9) + ": " + describe(cause), cause);
    this.strand = strand;
    this.timeNs = timeNs;
  }

  /** The name of the strand, which is the robot's name. */
  public String strand() {
    return strand;
  }

  /** The time of the exception, in ns of virtual time. */
  public long timeNs() {
    return timeNs;
  }

  private static String describe(Throwable cause) {
    String message = cause.getMessage();
    String type = cause.getClass().getSimpleName();
    String place = AppFrame.of(cause.getStackTrace());
    return type
        + (message == null ? "" : ": " + message)
        + (place.isEmpty() ? "" : "; at " + place);
  }
}

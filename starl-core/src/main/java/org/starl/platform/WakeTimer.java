package org.starl.platform;

/** The timer of a state machine that states when it is due. Sets the port only on a change. */
public final class WakeTimer {

  /** The time of a state machine that waits for no time. */
  public static final long NEVER = Long.MAX_VALUE;

  private final Timer timer;
  private final Runnable due;
  private long setForNs = NEVER;

  /**
   * @param due runs on the strand at the time that was set
   */
  public WakeTimer(Timers timers, Runnable due) {
    this.due = due;
    this.timer = timers.timer(this::expired);
  }

  /** Sets the time, in place of an earlier one; {@link #NEVER} cancels. */
  public void set(long atNs) {
    if (atNs == setForNs) {
      return; // the common case
    }
    setForNs = atNs;
    if (atNs == NEVER) {
      timer.cancel();
    } else {
      timer.set(atNs);
    }
  }

  private void expired() {
    setForNs = NEVER;
    due.run();
  }
}

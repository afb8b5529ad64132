package org.starl.platform;

/** Creates timers whose actions run on the robot's strand. */
public interface Timers {

  /** Creates a timer that is not set. {@code action} runs on the strand at each expiry. */
  Timer timer(Runnable action);
}

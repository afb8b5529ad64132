package org.starl.platform;

/** Makes timers whose actions run on the robot's strand. */
public interface Timers {

  /** A new timer, not set. {@code action} runs on the strand each time the timer expires. */
  Timer timer(Runnable action);
}

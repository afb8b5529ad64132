package org.starl.ros2;

import java.io.IOException;
import org.starl.body.WheelCommand;

/** The way of speeds to a base. */
interface SpeedLink extends AutoCloseable {

  /** Opens one. */
  @FunctionalInterface
  interface Source {
    SpeedLink open() throws IOException;
  }

  /** Sends speeds, which are valid now. */
  void send(WheelCommand speeds);

  /** Whether the base receives what is sent. */
  boolean isReceived();

  /** False if it is to be replaced. */
  boolean isAlive();

  /** Stops the wheels if it can. */
  @Override
  void close();
}

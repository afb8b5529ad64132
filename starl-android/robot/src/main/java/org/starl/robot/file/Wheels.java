package org.starl.robot.file;

import org.jspecify.annotations.Nullable;

/** What a robot drives on. */
public sealed interface Wheels {

  /**
   * An iRobot Create.
   *
   * @param model {@code create1} or {@code create2}
   * @param port where its bytes come and go
   * @param baud of a serial line, in bits a second
   * @param simulatedAt where the deployment's world simulates the other end; null for a real one
   */
  record Create(String model, Port port, int baud, @Nullable Port simulatedAt) implements Wheels {}

  /** A body in the deployment's world, whose process runs the robot's program as well. */
  record Simulated() implements Wheels {}

  /** Where bytes come and go. */
  sealed interface Port {}

  /** A serial device or a pseudo-terminal, by its path. */
  record Device(String path) implements Port {
    @Override
    public String toString() {
      return path;
    }
  }

  /** A TCP connection; who simulates listens, the robot connects. */
  record Tcp(HostPort address) implements Port {
    @Override
    public String toString() {
      return "tcp:" + address;
    }
  }
}

package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * Bytes both ways: a serial port, a Bluetooth or TCP socket. One thread reads, one writes, any
 * closes; closing ends a read or write that waits, by its end or an exception.
 */
public interface ByteLink extends Closeable {

  InputStream input() throws IOException;

  OutputStream output() throws IOException;

  /** Opens links to one and the same robot, again after each loss. */
  @FunctionalInterface
  interface Source {
    /**
     * A new link; it may take its time.
     *
     * @throws IOException if there is none now: it is asked again later
     */
    ByteLink open() throws IOException;
  }
}

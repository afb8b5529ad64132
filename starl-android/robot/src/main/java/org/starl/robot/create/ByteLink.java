package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * A link that carries bytes both ways: a serial port, a Bluetooth or TCP socket. One thread reads, one
 * writes, any thread closes; closing ends a waiting read or write, with the end of the stream or an
 * exception.
 */
public interface ByteLink extends Closeable {

  InputStream input() throws IOException;

  OutputStream output() throws IOException;

  /** Opens links to one robot: a new link after each loss. */
  @FunctionalInterface
  interface Source {
    /**
     * Opens a link; may block.
     *
     * @throws IOException if no link can be opened now: the caller tries again later
     */
    ByteLink open() throws IOException;
  }
}

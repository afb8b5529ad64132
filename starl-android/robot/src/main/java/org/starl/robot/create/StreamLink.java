package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * A link over two streams.
 *
 * @param name of the link, for messages
 * @param end closes the link
 */
public record StreamLink(String name, InputStream input, OutputStream output, Closeable end)
    implements ByteLink {

  @Override
  public void close() throws IOException {
    end.close();
  }

  @Override
  public String toString() {
    return name;
  }
}

package org.starl.deployment;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import org.jspecify.annotations.Nullable;

/**
 * Lines of a conversation whose words are short, from somebody who may be anybody: ASCII, each ended by
 * {@code \n}. Who sends more than a line can have is not listened to.
 */
final class ShortLines implements Closeable {

  /** No line is longer: a robot's name has half as many letters. */
  static final int MAX_LENGTH = 64;

  private final InputStream in;

  ShortLines(InputStream in) {
    this.in = in;
  }

  /**
   * The next line without its end, or null after the last; what is not ended is no line.
   *
   * @throws IOException if it is too long, or is no text
   */
  @Nullable String next() throws IOException {
    StringBuilder line = new StringBuilder(MAX_LENGTH);
    for (int c = in.read(); c >= 0; c = in.read()) {
      if (c == '\n') {
        return line.toString();
      }
      if (c < 0x20 || c > 0x7E || line.length() == MAX_LENGTH) {
        throw new IOException(
            "something that is no line: expected up to " + MAX_LENGTH + " letters of ASCII");
      }
      line.append((char) c);
    }
    return null;
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}

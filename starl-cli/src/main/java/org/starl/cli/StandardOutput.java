package org.starl.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;

/**
 * Standard output. When the program that reads it has ended ({@code starl list | head -1}), this
 * process ends at once and without a word, as the signal SIGPIPE, which the JVM ignores, ends
 * others.
 */
final class StandardOutput extends FilterOutputStream {

  /** What a shell says of a program that SIGPIPE ended. */
  static final int STATUS = 141;

  private final Runnable ended;

  /**
   * @param ended called before the process ends
   */
  StandardOutput(Runnable ended) {
    super(new FileOutputStream(FileDescriptor.out));
    this.ended = ended;
  }

  @Override
  public void write(byte[] bytes, int from, int length) throws IOException {
    try {
      out.write(bytes, from, length);
    } catch (IOException e) {
      if (String.valueOf(e.getMessage()).contains("roken pipe")) {
        ended.run();
        System.exit(STATUS);
      }
      throw e;
    }
  }
}

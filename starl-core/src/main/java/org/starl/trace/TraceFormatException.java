package org.starl.trace;

import java.io.IOException;

/** A line is not valid in a trace. The message names file, line, column and what was expected. */
public final class TraceFormatException extends IOException {

  private static final long serialVersionUID = 1L;

  TraceFormatException(String file, long line, String problem) {
    super(file + ":" + line + ": " + problem);
  }
}

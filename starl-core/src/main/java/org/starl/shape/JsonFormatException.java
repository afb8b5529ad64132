package org.starl.shape;

import java.io.IOException;

/** A line is not as its shape requires. The message names file, line, column and what was expected. */
public final class JsonFormatException extends IOException {

  private static final long serialVersionUID = 1L;

  public JsonFormatException(String file, long line, String problem) {
    super(file + ":" + line + ": " + problem);
  }
}

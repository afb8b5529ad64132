package org.starl.lang.read;

import org.starl.lang.tree.Pos;

/**
 * Something wrong in a source.
 *
 * @param message what was found and what was expected, on one line
 */
public record SourceError(String file, Pos pos, String message) {

  /** {@code Mutex.starl:12:7: 'RSS' is not known here; expected ...}. */
  @Override
  public String toString() {
    return file + ":" + pos + ": " + message;
  }
}

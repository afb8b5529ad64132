package org.starl.apps;

import java.io.IOException;
import java.io.OutputStream;

/**
 * A file that a run of an app produces: {@code starl run APP --result NAME} writes it.
 *
 * @param ending of the file's name, such as {@code .svg}
 * @param content called once, after the run
 */
public record Product(String ending, Content content) {

  /** Writes the file. */
  @FunctionalInterface
  public interface Content {
    void write(OutputStream out) throws IOException;
  }
}

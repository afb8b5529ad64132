package org.starl.apps;

import java.io.IOException;
import java.io.OutputStream;

/**
 * A file that an app's run has to give: {@code starl run APP --result NAME} writes it.
 *
 * @param ending of the file's name, as in {@code .svg}
 * @param content asked once, after the run
 */
public record Product(String ending, Content content) {

  /** What is in the file. */
  @FunctionalInterface
  public interface Content {
    void write(OutputStream out) throws IOException;
  }
}

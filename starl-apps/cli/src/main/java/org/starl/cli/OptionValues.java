package org.starl.cli;

import java.util.function.Function;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Parses the values of options. */
final class OptionValues {

  private OptionValues() {}

  /**
   * The value that {@code reader} reads.
   *
   * @throws BadInput with the option's name, if the reader refuses the text
   */
  static <T> T read(String option, String text, Function<String, T> reader) {
    try {
      return reader.apply(text);
    } catch (BadInput error) {
      throw Quantities.in(option, error);
    }
  }

  /** A whole number; both ends are included. */
  static int whole(String option, String text, int min, int max) {
    return read(option, text, number -> (int) Quantities.whole(number, min, max));
  }
}

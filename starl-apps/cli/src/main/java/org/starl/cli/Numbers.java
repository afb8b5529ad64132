package org.starl.cli;

import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Parses the numbers of options. */
final class Numbers {

  private Numbers() {}

  /**
   * @throws BadInput with the option's name, unless {@code text} is a whole number in the range
   */
  static long whole(String option, String text, long min, long max) {
    try {
      return Quantities.whole(text, min, max);
    } catch (BadInput error) {
      throw Quantities.in(option, error);
    }
  }
}

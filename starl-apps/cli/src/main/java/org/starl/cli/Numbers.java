package org.starl.cli;

import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Numbers that options give. */
final class Numbers {

  private Numbers() {}

  /**
   * @throws BadInput that names the option, if {@code text} is no whole number in the range
   */
  static long whole(String option, String text, long min, long max) {
    try {
      return Quantities.whole(text, min, max);
    } catch (BadInput error) {
      throw Quantities.in(option, error);
    }
  }
}

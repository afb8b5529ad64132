package org.starl.input;

import java.util.List;

/**
 * The values that a setting or a parameter takes, for tools such as editors. It repeats the checks of
 * the reader as far as a pattern can; the reader is the authority.
 */
public sealed interface Form {

  /** Anything that fits on a line. */
  Form TEXT = new Text("");

  /** True or false. */
  Form YES_NO = new YesNo();

  /** Faults, one or several. */
  Form FAULTS = new Faults();

  /** A whole number, {@code least} and {@code most} among them. */
  record Whole(long least, long most) implements Form {}

  /** A quantity with its unit, at least 0, or above 0. */
  record Amount(Quantity quantity, boolean isAboveZero) implements Form {}

  /** One of these words. */
  record Choice(List<String> values) implements Form {
    public Choice {
      values = List.copyOf(values);
    }
  }

  /** {@code true} or {@code false}; {@code yes no on off} are read as well. */
  record YesNo() implements Form {}

  /** A text that a regular expression matches as a whole; any text if that is empty. */
  record Text(String pattern) implements Form {}

  /** Faults in their grammar. */
  record Faults() implements Form {}

  static Form whole(long least, long most) {
    return new Whole(least, most);
  }

  /** A quantity of at least 0. */
  static Form amount(Quantity quantity) {
    return new Amount(quantity, false);
  }

  /** A quantity above 0. */
  static Form above0(Quantity quantity) {
    return new Amount(quantity, true);
  }

  static Form choice(List<String> values) {
    return new Choice(values);
  }
}

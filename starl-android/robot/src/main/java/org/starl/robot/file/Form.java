package org.starl.robot.file;

import java.util.Arrays;
import java.util.List;
import java.util.Map;

/** Which values a {@link Field} takes. */
public sealed interface Form {

  /**
   * Any text.
   *
   * @param expected what it should be, for messages
   */
  record Text(String expected) implements Form {}

  /** One of these. */
  record Choice(List<String> values) implements Form {
    public Choice {
      values = List.copyOf(values);
    }

    static Choice of(String... values) {
      return new Choice(Arrays.asList(values));
    }
  }

  /** {@code true} or {@code yes}, {@code false} or {@code no}. */
  record YesNo() implements Form {}

  /** A whole number in decimal digits, both ends included. */
  record Whole(long least, long most) implements Form {}

  /** A decimal number, both ends included. */
  record Amount(double least, double most) implements Form {}

  /**
   * {@code HOST:PORT}, {@code [IPV6]:PORT}.
   *
   * @param needsPort whether HOST alone will not do
   */
  record Address(boolean needsPort) implements Form {}

  /** The path of a device, or {@code tcp:HOST:PORT}. */
  record Port() implements Form {}

  /** Lines beneath. */
  record Lines(String expected, List<Field> fields) implements Form {
    public Lines {
      fields = List.copyOf(fields);
    }
  }

  /**
   * Lines beneath, one of which says which others there are.
   *
   * @param by takes a {@link Choice} of the kinds
   * @param kinds what each has besides, in the order of the choice
   */
  record Kinds(String expected, Field by, Map<String, List<Field>> kinds) implements Form {}

  /** A line for each robot by its name, of the form of {@code each}. */
  record Named(String expected, Form.Lines each) implements Form {}

  /** A line for each parameter and setting that the app has; one value each. */
  record Parameters(String expected) implements Form {}
}

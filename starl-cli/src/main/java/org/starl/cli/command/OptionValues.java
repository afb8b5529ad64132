package org.starl.cli.command;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Parses the values of options. */
public final class OptionValues {

  private OptionValues() {}

  /**
   * The value that {@code reader} reads.
   *
   * @throws BadInput with the option's name, if the reader refuses the text
   */
  public static <T> T read(String option, String text, Function<String, T> reader) {
    try {
      return reader.apply(text);
    } catch (BadInput error) {
      throw Quantities.in(option, error);
    }
  }

  /** A whole number; both ends are included. */
  public static int whole(String option, String text, int min, int max) {
    return read(option, text, number -> (int) Quantities.whole(number, min, max));
  }

  /**
   * The values of an option that is repeated, by their names, in order.
   *
   * @param given such as {@code robots=3}
   * @param form what is expected: {@code KEY=VALUE}
   * @throws BadInput if one has no name, or a name is there twice
   */
  public static Map<String, String> named(String option, List<String> given, String form) {
    Map<String, String> named = new LinkedHashMap<>();
    for (String each : given) {
      int equals = each.indexOf('=');
      if (equals < 1) {
        throw new BadInput(option + ": " + BadInput.quote(each) + ": expected " + form);
      }
      String name = each.substring(0, equals).strip();
      if (named.put(name, each.substring(equals + 1)) != null) {
        throw new BadInput(option + " " + name + ": expected it once");
      }
    }
    return named;
  }

  /**
   * The names of the options that are given.
   *
   * @param namesAndValues alternating; a value that is null or false is not given
   */
  public static String[] given(@Nullable Object... namesAndValues) {
    List<String> given = new ArrayList<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      Object value = namesAndValues[i + 1];
      if (value != null && !value.equals(false)) {
        given.add(String.valueOf(namesAndValues[i]));
      }
    }
    return given.toArray(String[]::new);
  }
}

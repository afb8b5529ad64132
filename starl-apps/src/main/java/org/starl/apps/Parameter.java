package org.starl.apps;

import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;

/**
 * A parameter of an app, for {@code --set key=value}. Its form is all that is said of its values: texts
 * are checked and read by it ({@link Request#whole}, {@link Request#amount}), and help and schemas
 * show it.
 *
 * @param what its meaning, in one line, without its values
 * @param form its values besides the default
 */
public record Parameter(String key, String defaultValue, String what, Form form) {

  /** A parameter that takes any text: the app checks it. */
  public Parameter(String key, String defaultValue, String what) {
    this(key, defaultValue, what, Form.TEXT);
  }

  /** A parameter with one of these values; the first is the default. */
  public static Parameter choice(String key, String what, String... values) {
    return new Parameter(key, values[0], what, Form.choice(List.of(values)));
  }

  /**
   * The value of a text, as {@link Form#value} has it.
   *
   * @throws BadInput if it is no value; the message begins with the key
   */
  public Object value(String text) {
    try {
      return Form.value(form, text);
    } catch (BadInput error) {
      throw Quantities.in(key, error);
    }
  }

  /** Meaning and values, for help. */
  public String text() {
    boolean isAny = form instanceof Form.Text;
    return isAny ? what : what + "; " + Form.expected(form);
  }

  /**
   * The values of all parameters: the given ones, else the defaults.
   *
   * @throws BadInput if a given one is neither its default nor of its form
   */
  public static SortedMap<String, String> values(
      List<Parameter> declared, Map<String, String> given) {
    SortedMap<String, String> values = new TreeMap<>();
    for (Parameter parameter : declared) {
      String value = given.getOrDefault(parameter.key, parameter.defaultValue);
      if (!value.equals(parameter.defaultValue)) {
        parameter.value(value);
      }
      values.put(parameter.key, value);
    }
    return values;
  }
}

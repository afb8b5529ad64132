package org.starl.apps;

import org.starl.input.Form;

/**
 * Something of an app's scenario that {@code --set key=value} may change.
 *
 * @param what one line, with the values that it takes
 * @param form which values it takes, for editors of scenario files; besides the default
 */
public record Parameter(String key, String defaultValue, String what, Form form) {

  /** One that takes any text, as far as an editor is to know. */
  public Parameter(String key, String defaultValue, String what) {
    this(key, defaultValue, what, Form.TEXT);
  }
}

package org.starl.apps;

import org.starl.input.Form;

/**
 * A parameter of an app, for {@code --set key=value}.
 *
 * @param what its meaning and its values, in one line
 * @param form its values besides the default, for editors of scenario files
 */
public record Parameter(String key, String defaultValue, String what, Form form) {

  /** A parameter for which an editor accepts any text. */
  public Parameter(String key, String defaultValue, String what) {
    this(key, defaultValue, what, Form.TEXT);
  }
}

package org.starl.apps;

import java.util.OptionalInt;
import java.util.SortedMap;

/**
 * What a user asks of an app.
 *
 * @param robots how many, where the user says so
 * @param parameters of the app, every one of them: the user's values over the defaults
 */
public record Request(long seed, OptionalInt robots, SortedMap<String, String> parameters) {

  /** The value of a parameter that the app has declared. */
  public String parameter(String key) {
    String value = parameters.get(key);
    if (value == null) {
      throw new IllegalArgumentException("no parameter '" + key + "'");
    }
    return value;
  }
}

package org.starl.robot.file;

import org.jspecify.annotations.Nullable;

/**
 * A line of a deployment file.
 *
 * @param key what stands before its colon
 * @param says what it means, with the unit of its value, for people who write one
 * @param isNeeded whether it must be there
 * @param usual its value where it is not there; null if there is none, or it depends on others
 */
public record Field(String key, Form form, String says, boolean isNeeded, @Nullable String usual) {

  static Field needed(String key, Form form, String says) {
    return new Field(key, form, says, true, null);
  }

  static Field optional(String key, Form form, String says) {
    return new Field(key, form, says, false, null);
  }

  static Field usually(String usual, String key, Form form, String says) {
    return new Field(key, form, says, false, usual);
  }
}

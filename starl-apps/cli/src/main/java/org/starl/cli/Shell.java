package org.starl.cli;

import java.util.List;
import java.util.regex.Pattern;

/** Words of a command line that a person can paste. */
final class Shell {

  /** System property: how a person calls this program, where that is not {@code ./starl}. */
  static final String LAUNCHER = "starl.launcher";

  private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./=:,@%+-]+");

  private Shell() {}

  /** {@code word} as a POSIX shell reads it back. */
  static String quote(String word) {
    return PLAIN.matcher(word).matches() ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  /** The command line {@code ./starl WORD...}, or with the launcher's name in place of that. */
  static String starl(List<String> words) {
    StringBuilder line = new StringBuilder(System.getProperty(LAUNCHER, "./starl"));
    words.forEach(word -> line.append(' ').append(quote(word)));
    return line.toString();
  }
}

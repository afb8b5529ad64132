package org.starl.cli;

import java.util.List;
import java.util.regex.Pattern;

/** Command lines to paste into a shell. */
final class Shell {

  /** System property: the command that starts this program, if it is not {@code ./starl}. */
  static final String LAUNCHER = "starl.launcher";

  private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./=:,@%+-]+");

  private Shell() {}

  /** Quotes {@code word} for a POSIX shell, if necessary. */
  static String quote(String word) {
    return PLAIN.matcher(word).matches() ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  /** The command that starts this program. */
  static String launcher() {
    return System.getProperty(LAUNCHER, "./starl");
  }

  /** The command line {@code ./starl WORD...}, or with the launcher of {@link #LAUNCHER}. */
  static String starl(List<String> words) {
    StringBuilder line = new StringBuilder(launcher());
    words.forEach(word -> line.append(' ').append(quote(word)));
    return line.toString();
  }
}

package org.starl.cli;

import java.util.List;
import java.util.regex.Pattern;

/** Words of a command line that a person can paste. */
final class Shell {

  private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./=:,@%+-]+");

  private Shell() {}

  /** {@code word} as a POSIX shell reads it back. */
  static String quote(String word) {
    return PLAIN.matcher(word).matches() ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  /** The command line {@code ./starl WORD...}. */
  static String starl(List<String> words) {
    StringBuilder line = new StringBuilder("./starl");
    words.forEach(word -> line.append(' ').append(quote(word)));
    return line.toString();
  }
}

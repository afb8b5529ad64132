package org.starl.cli.command;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.input.BadInput;

/** Command lines to paste into a shell. */
public final class Shell {

  /** System property: the command that starts this program, if it is not {@code ./starl}. */
  static final String LAUNCHER = "starl.launcher";

  private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./=:,@%+-]+");

  /** Of a line: in single quotes, in double quotes, after a backslash, plain, or between words. */
  private static final Pattern PART =
      Pattern.compile("'([^']*)'|\"([^\"]*)\"|\\\\(.)|([^\\s'\"\\\\]+)|\\s+");

  private Shell() {}

  /** Quotes {@code word} for a POSIX shell, if necessary. */
  public static String quote(String word) {
    return PLAIN.matcher(word).matches() ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  /**
   * The words of a line as a POSIX shell splits it: by spaces outside of quotes. In double quotes a
   * backslash stands for itself.
   *
   * @throws BadInput if a quote has no end
   */
  public static List<String> words(String line) {
    Matcher parts = PART.matcher(line.strip());
    List<String> words = new ArrayList<>();
    StringBuilder word = new StringBuilder();
    int end = 0;
    while (end < line.strip().length()) {
      if (!parts.find() || parts.start() != end) {
        throw new BadInput("expected an end of each quote");
      }
      end = parts.end();
      if (parts.group().isBlank()) {
        words.add(word.toString());
        word.setLength(0);
      } else {
        String quoted = parts.group(1) != null ? parts.group(1) : parts.group(2);
        String escaped = parts.group(3) != null ? parts.group(3) : parts.group(4);
        word.append(quoted != null ? quoted : escaped);
      }
    }
    words.add(word.toString());
    return words;
  }

  /** The command that starts this program. */
  public static String launcher() {
    return System.getProperty(LAUNCHER, "./starl");
  }

  /** The command line {@code ./starl WORD...}, or with the launcher of {@link #LAUNCHER}. */
  public static String starl(List<String> words) {
    StringBuilder line = new StringBuilder(launcher());
    words.forEach(word -> line.append(' ').append(quote(word)));
    return line.toString();
  }
}

package org.starl.input;

/**
 * A user's input (a file, a flag, a setting) is wrong. The message is one whole line for the user:
 * the place, the value, and the expected form. It does not mean a bug: the stack
 * trace only shows which code refused the input.
 */
public final class BadInput extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private static final int LONGEST_QUOTE = 60;
  private static final int LONGEST_LINE = 1_000;

  public BadInput(String line) {
    super(line);
  }

  /**
   * An error in line {@code line} of {@code file}, such as {@code my.yaml:3: app: ...}.
   *
   * @param text may contain parts of the file: it is cut where long, and stays on one line
   */
  public static BadInput at(String file, int line, String text) {
    String whole = file + ":" + line + ": " + text;
    return new BadInput(
        printable(whole, LONGEST_LINE) + (whole.length() > LONGEST_LINE ? "..." : ""));
  }

  /** {@code text} in quotes for one line: shortened if long, without control characters. */
  public static String quote(String text) {
    return "'" + printable(text, LONGEST_QUOTE) + (text.length() > LONGEST_QUOTE ? "...'" : "'");
  }

  private static String printable(String text, int longest) {
    int length = Math.min(text.length(), longest);
    StringBuilder printable = new StringBuilder(length);
    for (int i = 0; i < length; i++) {
      char c = text.charAt(i);
      boolean isBreak = Character.isISOControl(c) || c == '\u2028' || c == '\u2029';
      printable.append(isBreak || c == '\uFFFD' ? '?' : c);
    }
    return printable.toString();
  }
}

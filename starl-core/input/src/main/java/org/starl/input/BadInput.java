package org.starl.input;

/**
 * What a person gave to a simulation (a file, a flag, a setting) is not what was expected. The
 * message is one whole line for that person: where, what, and what was expected. It is no bug: the
 * stack trace is for who asks how that line came about.
 */
public final class BadInput extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private static final int LONGEST_QUOTE = 60;

  public BadInput(String line) {
    super(line);
  }

  /** {@code text} in quotes, fit for one line: cut where long, without control characters. */
  public static String quote(String text) {
    StringBuilder quoted = new StringBuilder("'");
    int length = Math.min(text.length(), LONGEST_QUOTE);
    for (int i = 0; i < length; i++) {
      char c = text.charAt(i);
      quoted.append(Character.isISOControl(c) || c == '\uFFFD' ? '?' : c);
    }
    return quoted.append(length < text.length() ? "...'" : "'").toString();
  }
}

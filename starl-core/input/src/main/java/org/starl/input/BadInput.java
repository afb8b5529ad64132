package org.starl.input;

/**
 * A user's input (a file, an option, a setting) is not what was expected. The message is one whole
 * line for that user: where it stands, what it is, and what was expected. It is not a bug.
 */
public final class BadInput extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private static final int LONGEST_QUOTE = 60;

  public BadInput(String line) {
    super(line);
  }

  /** {@code text} in quotes for one line: shortened if long, without control characters. */
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

package org.starl.build;

/** Just enough of Java's lexical grammar to tell code from comments and literals. */
final class JavaText {

  private enum In {
    CODE,
    LINE_COMMENT,
    COMMENT,
    STRING,
    TEXT_BLOCK,
    CHARACTER
  }

  private final String text;
  private final StringBuilder out;
  private In in = In.CODE;
  private int at;

  private JavaText(String text) {
    this.text = text;
    this.out = new StringBuilder(text.length());
  }

  /**
   * The text with spaces for comments and for what stands inside literals; every line keeps its
   * number and length.
   */
  static String codeOf(String text) {
    return new JavaText(text).run();
  }

  private String run() {
    while (at < text.length()) {
      switch (in) {
        case CODE -> inCode();
        case LINE_COMMENT -> inside("\n");
        case COMMENT -> inside("*/");
        case STRING -> inside("\"");
        case TEXT_BLOCK -> inside("\"\"\"");
        case CHARACTER -> inside("'");
      }
    }
    return out.toString();
  }

  private void inCode() {
    boolean entered =
        enters("//", In.LINE_COMMENT)
            || enters("/*", In.COMMENT)
            || enters("\"\"\"", In.TEXT_BLOCK)
            || enters("\"", In.STRING)
            || enters("'", In.CHARACTER);
    if (!entered) {
      out.append(text.charAt(at++));
    }
  }

  private boolean enters(String opening, In next) {
    if (!text.startsWith(opening, at)) {
      return false;
    }
    in = next;
    out.append(isComment() ? " ".repeat(opening.length()) : opening);
    at += opening.length();
    return true;
  }

  private void inside(String closing) {
    if (text.startsWith(closing, at)) {
      out.append(in == In.COMMENT ? "  " : closing);
      at += closing.length();
      in = In.CODE;
      return;
    }
    if (!isComment() && text.charAt(at) == '\\') {
      blank();
    }
    blank();
  }

  private boolean isComment() {
    return in == In.LINE_COMMENT || in == In.COMMENT;
  }

  private void blank() {
    if (at < text.length()) {
      out.append(text.charAt(at++) == '\n' ? '\n' : ' ');
    }
  }
}

package org.starl.lang.prove;

import java.util.ArrayList;
import java.util.List;

/**
 * A word, or expressions in parentheses.
 *
 * @param word empty if it is a list
 */
record SExpr(String word, List<SExpr> parts) {

  /** The first expression of a text. */
  static SExpr read(String text) {
    return new Reader(text).next();
  }

  /** The part at {@code index} of a list. */
  SExpr at(int index) {
    return parts.get(index);
  }

  @Override
  public String toString() {
    if (!word.isEmpty()) {
      return word;
    }
    StringBuilder all = new StringBuilder("(");
    for (SExpr part : parts) {
      all.append(all.length() > 1 ? " " : "").append(part);
    }
    return all.append(')').toString();
  }

  private static final class Reader {

    private final String text;
    private int at;

    Reader(String text) {
      this.text = text;
    }

    SExpr next() {
      skipSpace();
      if (text.charAt(at) != '(') {
        int from = at;
        while (at < text.length() && "() \n\r\t".indexOf(text.charAt(at)) < 0) {
          at++;
        }
        return new SExpr(text.substring(from, at), List.of());
      }
      at++;
      List<SExpr> parts = new ArrayList<>();
      for (skipSpace(); text.charAt(at) != ')'; skipSpace()) {
        parts.add(next());
      }
      at++;
      return new SExpr("", List.copyOf(parts));
    }

    private void skipSpace() {
      while (Character.isWhitespace(text.charAt(at))) {
        at++;
      }
    }
  }
}

package org.starl.cli.report;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;

/**
 * Writes a page that parses as HTML and as XML alike. Every text and every attribute's value is
 * escaped; what cannot stand in XML at all becomes U+FFFD.
 */
final class Html {

  private static final Set<String> ON_LINES =
      Set.of(
          "head",
          "body",
          "meta",
          "title",
          "style",
          "script",
          "header",
          "main",
          "section",
          "article",
          "footer",
          "h1",
          "h2",
          "h3",
          "p",
          "div",
          "figure",
          "figcaption",
          "table",
          "thead",
          "tbody",
          "tr",
          "ul",
          "ol",
          "li",
          "dl",
          "dt",
          "dd",
          "details",
          "svg",
          "g",
          "rect",
          "path",
          "line",
          "circle",
          "nav");

  private static final char REPLACEMENT = '\uFFFD';

  private final StringBuilder page = new StringBuilder("<!DOCTYPE html>");
  private final Deque<String> open = new ArrayDeque<>();

  /**
   * Opens an element; {@link #close} closes it.
   *
   * @param attributes names and values in turn; an empty {@code class} is left out
   */
  Html open(String tag, String... attributes) {
    begin(tag, attributes);
    page.append('>');
    open.push(tag);
    return this;
  }

  /** Closes the element that was opened last. */
  Html close() {
    page.append("</").append(open.pop()).append('>');
    return this;
  }

  /** An element with nothing but text. */
  Html element(String tag, String text, String... attributes) {
    return open(tag, attributes).text(text).close();
  }

  /** An element that never has content: {@code meta}, {@code img}, shapes of a drawing. */
  Html empty(String tag, String... attributes) {
    begin(tag, attributes);
    page.append("/>");
    return this;
  }

  Html text(String text) {
    escape(text);
    return this;
  }

  /**
   * Style or script of this package.
   *
   * @throws IllegalArgumentException if HTML and XML would read it in two ways
   */
  Html code(String tag, String code) {
    if (code.indexOf('<') >= 0 || code.indexOf('&') >= 0 || code.contains("]]>")) {
      throw new IllegalArgumentException("a " + tag + " with '<', '&' or ']]>' in it");
    }
    open(tag);
    page.append(code);
    return close();
  }

  /** A command line to paste: lines end between its words, not behind their hyphens. */
  Html command(String command) {
    open("code", "class", "command");
    String[] words = command.split(" ", -1);
    for (int i = 0; i < words.length; i++) {
      if (i > 0) {
        text(" ");
      }
      element("span", words[i]);
    }
    return close();
  }

  /** The whole page. */
  String page() {
    if (!open.isEmpty()) {
      throw new IllegalStateException("still open: " + open);
    }
    return page + "\n";
  }

  private void begin(String tag, String... attributes) {
    if (ON_LINES.contains(tag)) {
      page.append('\n');
    }
    page.append('<').append(tag);
    for (int i = 0; i < attributes.length; i += 2) {
      if (attributes[i].equals("class") && attributes[i + 1].isEmpty()) {
        continue;
      }
      page.append(' ').append(attributes[i]).append("=\"");
      escape(attributes[i + 1]);
      page.append('"');
    }
  }

  private void escape(String text) {
    int i = 0;
    while (i < text.length()) {
      int c = text.codePointAt(i);
      switch (c) {
        case '&' -> page.append("&amp;");
        case '<' -> page.append("&lt;");
        case '>' -> page.append("&gt;");
        case '"' -> page.append("&quot;");
        case '\'' -> page.append("&#39;");
        default -> page.appendCodePoint(mayStandInXml(c) ? c : REPLACEMENT);
      }
      i += Character.charCount(c);
    }
  }

  /** As XML 1.0, section 2.2 has it, without carriage returns and the C1 controls. */
  private static boolean mayStandInXml(int c) {
    if (c < ' ') {
      return c == '\t' || c == '\n';
    }
    boolean isControl = c >= 0x7F && c <= 0x9F;
    boolean isSurrogate = c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE;
    return !isControl && !isSurrogate && (c & 0xFFFE) != 0xFFFE;
  }
}

package org.starl.cli.report;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Writes a page that parses as HTML and as XML. Every text and every attribute's value is escaped.
 * Characters that XML does not allow become U+FFFD.
 */
final class Html {

  /** Elements that begin on a new line. */
  private static final Set<String> ON_OWN_LINE =
      Set.of(
          ("head body meta title style script header main section article footer h1 h2 h3 p div"
                  + " figure figcaption table thead tbody tr ul ol li dl dt dd details svg g rect"
                  + " path line circle nav")
              .split(" "));

  private static final char REPLACEMENT = '\uFFFD';

  private final StringBuilder page = new StringBuilder("<!DOCTYPE html>");
  private final Deque<String> open = new ArrayDeque<>();
  private final Map<String, String> sections = new LinkedHashMap<>();
  private int contentsAt;

  /**
   * Opens an element; {@link #close} closes it.
   *
   * @param attributes names and values, alternating; an empty {@code class} is left out
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

  /** Opens a section with a title, which the contents link. */
  Html section(String title) {
    String id = title.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    sections.put(id, title);
    return open("section", "id", id).element("h2", title);
  }

  /** The place of links to all sections, also those that follow. */
  Html contents() {
    contentsAt = page.length();
    return this;
  }

  /** An element that contains only text. */
  Html element(String tag, String text, String... attributes) {
    return open(tag, attributes).text(text).close();
  }

  /** An element without content: {@code meta}, {@code img}, shapes of a drawing. */
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
   * A style or script of this package.
   *
   * @throws IllegalArgumentException if HTML and XML would read it differently
   */
  Html code(String tag, String code) {
    if (code.indexOf('<') >= 0 || code.indexOf('&') >= 0 || code.contains("]]>")) {
      throw new IllegalArgumentException("a " + tag + " with '<', '&' or ']]>' in it");
    }
    open(tag);
    page.append(code);
    return close();
  }

  /** A command line to paste. Lines break between its words, not after their hyphens. */
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

  /** Begins what may be wider than a screen; the keyboard can scroll it. */
  Html wide() {
    return open("div", "class", "wide", "tabindex", "0");
  }

  /**
   * Opens a table with a caption and a row of headings, in its scrollable frame; {@link #endTable}
   * closes it. All columns but the first are numbers.
   */
  Html table(String cssClass, String caption, List<String> headings) {
    wide().open("table", "class", cssClass).element("caption", caption);
    open("thead").open("tr").element("th", headings.get(0), "scope", "col");
    for (String heading : headings.subList(1, headings.size())) {
      if (heading.isEmpty()) {
        element("td", "");
      } else {
        element("th", heading, "scope", "col", "class", "n");
      }
    }
    return close().close().open("tbody");
  }

  /** Opens a row whose first cell is a name in the code's font; {@link #close} closes it. */
  Html row(String name) {
    return open("tr").open("th", "scope", "row").element("code", name).close();
  }

  /** A cell with a number. */
  Html number(String text) {
    return element("td", text, "class", "n");
  }

  /** Closes the table's body, the table and its frame. */
  Html endTable() {
    return close().close().close();
  }

  /** The whole page. */
  String page() {
    if (!open.isEmpty()) {
      throw new IllegalStateException("still open: " + open);
    }
    if (contentsAt > 0) {
      Html links = new Html();
      links.page.setLength(0);
      links.open("nav", "class", "contents", "aria-label", "Contents").open("ul");
      sections.forEach(
          (id, title) -> links.open("li").element("a", title, "href", "#" + id).close());
      links.close().close();
      page.insert(contentsAt, links.page);
    }
    return page + "\n";
  }

  private void begin(String tag, String... attributes) {
    if (ON_OWN_LINE.contains(tag)) {
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
        default -> page.appendCodePoint(isAllowedInXml(c) ? c : REPLACEMENT);
      }
      i += Character.charCount(c);
    }
  }

  /** XML 1.0, section 2.2, without carriage returns and the C1 controls. */
  private static boolean isAllowedInXml(int c) {
    if (c < ' ') {
      return c == '\t' || c == '\n';
    }
    boolean isControl = c >= 0x7F && c <= 0x9F;
    boolean isSurrogate = c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE;
    return !isControl && !isSurrogate && (c & 0xFFFE) != 0xFFFE;
  }
}

package org.starl.lang.picture;

import java.util.List;

/** The text of an SVG file. Lengths are in pixels. */
final class Svg {

  static final int LINE = 15;

  private static final double CHARACTER = 7.25;
  private static final String FONT =
      "font-family=\"ui-monospace, Menlo, Consolas, 'DejaVu Sans Mono', monospace\""
          + " font-size=\"12\"";
  private static final String INK = "#1f2328";
  private static final String GUARD = "#0550ae";

  private final StringBuilder text = new StringBuilder();

  /** Room that a line needs. */
  static int widthOf(String line) {
    return (int) Math.ceil(line.length() * CHARACTER);
  }

  static int widthOf(List<String> lines) {
    return lines.stream().mapToInt(Svg::widthOf).max().orElse(0);
  }

  Svg box(int x, int y, int width, int height, boolean isLast) {
    rectangle(x, y, width, height, 9, "#ddf4ff");
    if (isLast) {
      rectangle(x + 3, y + 3, width - 6, height - 6, 7, "none");
    }
    return this;
  }

  private void rectangle(int x, int y, int width, int height, int radius, String fill) {
    line(
        "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"%d\" fill=\"%s\" stroke=\"%s\"/>"
            .formatted(x, y, width, height, radius, fill, INK));
  }

  Svg dot(int x, int y) {
    return line("<circle cx=\"%d\" cy=\"%d\" r=\"5\" fill=\"%s\"/>".formatted(x, y, INK));
  }

  /** A line with an arrow's head at its end. */
  Svg path(String path) {
    return line(
        "<path d=\"%s\" fill=\"none\" stroke=\"%s\" marker-end=\"url(#head)\"/>"
            .formatted(path, INK));
  }

  Svg name(int middle, int y, String name) {
    return line(
        "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" font-weight=\"bold\" fill=\"%s\">%s</text>"
            .formatted(middle, y, INK, escaped(name)));
  }

  /** The lines of an arrow, the first one's base at {@code y}. */
  Svg label(int x, int y, Arrow arrow) {
    int at = y;
    for (String each : arrow.guard()) {
      words(x, at, GUARD, each);
      at += LINE;
    }
    for (String each : arrow.effect()) {
      words(x, at, INK, each);
      at += LINE;
    }
    return this;
  }

  private void words(int x, int y, String colour, String words) {
    line(
        "<text x=\"%d\" y=\"%d\" fill=\"%s\" xml:space=\"preserve\">%s</text>"
            .formatted(x, y, colour, escaped(words)));
  }

  private Svg line(String line) {
    text.append("  ").append(line).append('\n');
    return this;
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }

  /** The whole file. */
  String file(String title, int width, int height) {
    return """
    <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d" %s>
      <title>%s</title>
      <defs>
        <marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" \
    orient="auto">
          <path d="M0 0L10 5L0 10z" fill="%s"/>
        </marker>
      </defs>
      <rect width="%d" height="%d" fill="white"/>
    %s</svg>
    """
        .formatted(width, height, width, height, FONT, escaped(title), INK, width, height, text);
  }
}

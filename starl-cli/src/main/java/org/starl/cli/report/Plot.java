package org.starl.cli.report;

import java.util.Locale;

/**
 * A chart: a figure with a title, two axes with ticks and units, and a field to draw on. It scales
 * to the width of its container. A table beside each chart has the same numbers.
 */
final class Plot {

  private static final int WIDTH = 480;
  private static final int HEIGHT = 290;
  private static final int LEFT = 52;
  private static final int RIGHT = 20;
  private static final int TOP = 30;
  private static final int BOTTOM = 50;
  private static final int FIELD_WIDTH = WIDTH - LEFT - RIGHT;
  private static final int FIELD_HEIGHT = HEIGHT - TOP - BOTTOM;
  private static final int TICK_GAP = 18;

  private final Html html;
  private final Axis x;
  private final Axis y;

  /**
   * Begins a figure.
   *
   * @param note under the title
   */
  Plot(Html html, String title, String note, Axis x, Axis y) {
    this.html = html;
    this.x = x;
    this.y = y;
    html.open("figure", "class", "chart");
    html.open("figcaption").element("strong", title);
    html.text(" ").element("span", note, "class", "note").close();
    String label =
        "%s. Horizontal: %s. Vertical: %s. %s".formatted(title, x.label(), y.label(), note);
    String viewBox = "0 0 " + WIDTH + " " + HEIGHT;
    html.open("svg", "viewBox", viewBox, "role", "img", "aria-label", label);
    html.element("title", title);
    axes();
  }

  private void axes() {
    html.open("g", "class", "grid");
    for (double tick : y.ticks()) {
      line(0, tick, x.max(), tick, tick == 0 ? "base" : "");
    }
    html.close();
    html.open("g", "class", "axis");
    for (double tick : y.ticks()) {
      label(LEFT - 8, yOf(tick) + 5, "end", y.text(tick));
    }
    for (double tick : x.ticks()) {
      double at = xOf(tick);
      html.empty("path", "d", "M" + px(at) + " " + px(yOf(0)) + "v5");
      label(at, yOf(0) + TICK_GAP + 3, "middle", x.text(tick));
    }
    label(LEFT - 44, 16, "start", y.label());
    label(WIDTH - RIGHT, HEIGHT - 8, "end", x.label());
    html.close();
  }

  private void label(double atX, double atY, String anchor, String text) {
    html.element("text", text, "x", px(atX), "y", px(atY), "text-anchor", anchor);
  }

  /** Ends the figure. */
  void end() {
    endSvg();
    html.close();
  }

  /** Ends the drawing; the figure goes on, until the caller closes it. */
  void endSvg() {
    html.close();
  }

  /** A dot with a tooltip. */
  void dot(double atX, double atY, String cssClass, String tip) {
    String cx = px(xOf(atX));
    html.open("circle", "cx", cx, "cy", px(yOf(atY)), "r", "4", "class", "dot " + cssClass);
    html.element("title", tip).close();
  }

  double xOf(double value) {
    return LEFT + FIELD_WIDTH * Math.min(value, x.max()) / x.max();
  }

  double yOf(double value) {
    return TOP + FIELD_HEIGHT * (1 - Math.min(value, y.max()) / y.max());
  }

  /** The position as text for an SVG path. */
  String at(double xValue, double yValue) {
    return px(xOf(xValue)) + " " + px(yOf(yValue));
  }

  void line(double fromX, double fromY, double toX, double toY, String cssClass) {
    String path = "M" + at(fromX, fromY) + "L" + at(toX, toY);
    html.empty("path", "d", path, "class", cssClass);
  }

  void path(String path, String cssClass) {
    html.empty("path", "d", path, "class", cssClass);
  }

  /** A bar from 0 to {@code height}, between two values, with a small gap to its neighbours. */
  void bar(double from, double to, double height) {
    double left = xOf(from) + 0.5;
    double width = Math.max(1, xOf(to) - left - 0.5);
    double top = yOf(height);
    rect("bar", left, top, width, yOf(0) - top).close();
  }

  /** A tooltip for the field between two values. */
  void tip(double from, double to, String tip) {
    rect("tip", xOf(from), TOP, xOf(to) - xOf(from), FIELD_HEIGHT).element("title", tip).close();
  }

  private Html rect(String cssClass, double left, double top, double width, double height) {
    return html.open(
        "rect",
        "class",
        cssClass,
        "x",
        px(left),
        "y",
        px(top),
        "width",
        px(width),
        "height",
        px(height));
  }

  /** A dot with its text on the right or, if there is no room, on the left. */
  void mark(double atX, double atY, String text) {
    double cx = xOf(atX);
    double cy = yOf(atY);
    html.empty("circle", "cx", px(cx), "cy", px(cy), "r", "4", "class", "mark");
    boolean isRight = cx < LEFT + FIELD_WIDTH * 0.62;
    String left = px(isRight ? cx + 10 : cx - 8);
    String top = px(isRight ? cy + 16 : cy - 8);
    String anchor = isRight ? "start" : "end";
    html.element("text", text, "class", "mark", "x", left, "y", top, "text-anchor", anchor);
  }

  static String px(double value) {
    String text = String.format(Locale.ROOT, "%.1f", value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }
}

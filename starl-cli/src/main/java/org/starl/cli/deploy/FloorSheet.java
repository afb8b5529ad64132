package org.starl.cli.deploy;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** A drawing of a floor, in mm, y upwards: as SVG in true size, or as PDF that fits a page of A4. */
final class FloorSheet {

  /** The colour of a line or a text. */
  enum Ink {
    /** What is taped. */
    TAPE(0xc01a1a),
    /** What stands there. */
    BODY(0x1a1a1a),
    /** Measures, and what helps to read them. */
    HELP(0x737380);

    private final int rgb;

    Ink(int rgb) {
      this.rgb = rgb;
    }

    private String hex() {
      return "#%06x".formatted(rgb);
    }

    private String pdf() {
      return numbers((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
    }
  }

  private record Line(List<Point> points, boolean isClosed, Ink ink) {}

  private record Words(Point at, String text, Ink ink) {}

  /** Height of letters, and width of lines, for a floor of a few metres. */
  static final double TEXT_MM = 70;

  private static final double LINE_MM = 8;
  private static final int CIRCLE_CORNERS = 48;
  private static final double A4_LONG_PT = 842;
  private static final double A4_SHORT_PT = 595;
  private static final double PT_PER_MM = 72 / 25.4;

  private final Rectangle page;
  private final List<Line> lines = new ArrayList<>();
  private final List<Words> words = new ArrayList<>();

  FloorSheet(Rectangle page) {
    this.page = page;
  }

  void line(Ink ink, Point... points) {
    lines.add(new Line(List.of(points), false, ink));
  }

  void outline(Ink ink, List<Point> points) {
    lines.add(new Line(points, true, ink));
  }

  void circle(Ink ink, Point centre, double radiusMm) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < CIRCLE_CORNERS; i++) {
      points.add(centre.plus(along(2 * StrictMath.PI * i / CIRCLE_CORNERS, radiusMm)));
    }
    outline(ink, points);
  }

  /** A line with a head at its end. */
  void arrow(Ink ink, Point from, double headingRad, double lengthMm) {
    Point tip = from.plus(along(headingRad, lengthMm));
    line(ink, from, tip);
    line(ink, tip.plus(along(headingRad + 2.7, 50)), tip, tip.plus(along(headingRad - 2.7, 50)));
  }

  void text(Ink ink, Point at, String text) {
    words.add(new Words(at, text, ink));
  }

  private static Point along(double headingRad, double mm) {
    return new Point(mm * StrictMath.cos(headingRad), mm * StrictMath.sin(headingRad));
  }

  String svg() {
    double width = page.xMaxMm() - page.xMinMm();
    double height = page.yMaxMm() - page.yMinMm();
    StringBuilder svg = new StringBuilder();
    svg.append(
        """
        <svg xmlns="http://www.w3.org/2000/svg" width="%smm" height="%smm" viewBox="%s">
        <style>@page { size: %smm %smm; margin: 0 } text { font: %spx sans-serif }</style>
        <g fill="none" stroke-width="%s">
        """
            .formatted(
                numbers(width),
                numbers(height),
                numbers(page.xMinMm(), -page.yMaxMm(), width, height),
                numbers(width),
                numbers(height),
                numbers(TEXT_MM),
                numbers(LINE_MM)));
    for (Line line : lines) {
      String points =
          line.points().stream()
              .map(point -> numbers(point.xMm()) + "," + numbers(-point.yMm()))
              .collect(Collectors.joining(" "));
      svg.append(
          "<%s points=\"%s\" stroke=\"%s\"/>%n"
              .formatted(line.isClosed() ? "polygon" : "polyline", points, line.ink().hex()));
    }
    svg.append("</g>\n");
    for (Words each : words) {
      String text = each.text().replace("&", "&amp;").replace("<", "&lt;");
      svg.append(
          "<text x=\"%s\" y=\"%s\" fill=\"%s\">%s</text>%n"
              .formatted(
                  numbers(each.at().xMm()), numbers(-each.at().yMm()), each.ink().hex(), text));
    }
    return svg.append("</svg>\n").toString();
  }

  /** One page, no larger than A4. A point of the page is one of the drawing, by the matrix at the beginning. */
  byte[] pdf() {
    double width = page.xMaxMm() - page.xMinMm();
    double height = page.yMaxMm() - page.yMinMm();
    double scale =
        Math.min(A4_LONG_PT / Math.max(width, height), A4_SHORT_PT / Math.min(width, height));
    StringBuilder draw = new StringBuilder();
    draw.append(
        numbers(scale, 0, 0, scale, -scale * page.xMinMm(), -scale * page.yMinMm())
            + " cm 1 j "
            + numbers(LINE_MM)
            + " w\n");
    for (Line line : lines) {
      draw.append(line.ink().pdf()).append(" RG ");
      String way = " m ";
      for (Point point : line.points()) {
        draw.append(numbers(point.xMm(), point.yMm())).append(way);
        way = " l ";
      }
      draw.append(line.isClosed() ? "s\n" : "S\n");
    }
    List<Words> all = new ArrayList<>(words);
    Point corner = new Point(page.xMinMm() + TEXT_MM, page.yMinMm() + TEXT_MM);
    all.add(new Words(corner, "scale 1 : %.0f".formatted(PT_PER_MM / scale), Ink.HELP));
    for (Words each : all) {
      draw.append(
          "BT %s rg /F %s Tf %s Td (%s) Tj ET%n"
              .formatted(
                  each.ink().pdf(),
                  numbers(TEXT_MM),
                  numbers(each.at().xMm(), each.at().yMm()),
                  each.text().replaceAll("[\\\\()]", "\\\\$0")));
    }
    return file(
        List.of(
            "<</Type/Catalog/Pages 2 0 R>>",
            "<</Type/Pages/Kids[3 0 R]/Count 1>>",
            "<</Type/Page/Parent 2 0 R/MediaBox[0 0 %s]/Contents 4 0 R/Resources<</Font<</F 5 0 R>>>>>>"
                .formatted(numbers(scale * width, scale * height)),
            "<</Length %s>>stream%n%sendstream".formatted(draw.length(), draw),
            "<</Type/Font/Subtype/Type1/BaseFont/Helvetica>>"));
  }

  private static byte[] file(List<String> objects) {
    StringBuilder pdf = new StringBuilder("%PDF-1.4\n");
    StringBuilder places = new StringBuilder("0000000000 65535 f \n");
    for (int i = 0; i < objects.size(); i++) {
      places.append("%010d 00000 n \n".formatted(pdf.length()));
      pdf.append("%d 0 obj%n%s%nendobj%n".formatted(i + 1, objects.get(i)));
    }
    int table = pdf.length();
    int count = objects.size() + 1;
    pdf.append("xref\n0 " + count + "\n" + places)
        .append("trailer<</Size %d/Root 1 0 R>>%nstartxref%n%d%n%%%%EOF%n".formatted(count, table));
    return pdf.toString().getBytes(StandardCharsets.ISO_8859_1);
  }

  private static String numbers(double... values) {
    List<String> texts = new ArrayList<>();
    for (double value : values) {
      String text = String.format(Locale.ROOT, "%.4f", value);
      texts.add(text.replaceAll("\\.?0+$", ""));
    }
    return String.join(" ", texts);
  }
}

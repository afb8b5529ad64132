package org.starl.sim.view.page;

import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Painter.Section;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Viewport;

/** The app's drawing of a scene as shapes in the world's coordinates. Not thread-safe. */
public final class FloorShapes {

  private static final int UNITS_PER_MM = 10;
  private static final int CORNERS_OF_ELLIPSE = 32;

  /** A pixel is 1 mm; the origin is in the middle. */
  private static final Viewport VIEWPORT = new Viewport(2, 2, new Point(0, 0), 1);

  private final Painter painter = Painter.ofShapes();

  /**
   * One shape.
   *
   * @param rgba colour, as {@link java.awt.Color#getRGB}
   * @param sizeMm width of a line, or height of a text; 0 for a filled area
   * @param isClosed whether the last point is joined to the first
   * @param text of a text at the point; else empty
   * @param xyMm points, x and y alternating
   */
  @SuppressWarnings("ArrayRecordComponent") // equals and hashCode compare the points themselves
  public record Item(int rgba, double sizeMm, boolean isClosed, String text, double[] xyMm) {

    public boolean isFilled() {
      return sizeMm == 0;
    }

    @Override
    public boolean equals(@Nullable Object object) {
      return object instanceof Item other
          && rgba == other.rgba
          && sizeMm == other.sizeMm
          && isClosed == other.isClosed
          && text.equals(other.text)
          && Arrays.equals(xyMm, other.xyMm);
    }

    @Override
    public int hashCode() {
      return 31 * Arrays.hashCode(xyMm) + rgba;
    }
  }

  /** What the app draws under and over the bodies, without images. */
  public List<Item> of(Scene scene, Layer layer) {
    List<DrawnItem> drawn = new ArrayList<>();
    for (Section section : List.of(Section.FLOOR, Section.OVER)) {
      painter.paint(
          section, new ShapeRecorder(drawn), scene, layer, VIEWPORT, Look.FILE, List.of());
    }
    List<Item> items = new ArrayList<>();
    drawn.forEach(item -> add(items, item));
    return items;
  }

  private static void add(List<Item> items, DrawnItem item) {
    int[] n = item.numbers();
    switch (item.kind()) {
      case DrawnItem.LINE -> items.add(line(item, false, n));
      case DrawnItem.POLYGON -> items.add(line(item, true, n));
      case DrawnItem.ELLIPSE -> items.add(line(item, true, ellipse(n)));
      case DrawnItem.TEXT -> {
        double heightMm = 1.2 * n[0] / UNITS_PER_MM / Math.max(1, 0.6 * item.text().length());
        items.add(new Item(item.rgba(), heightMm, false, item.text(), world(n, 1)));
      }
      case DrawnItem.PATH -> addPath(items, item);
      default -> {} // an image has no shape
    }
  }

  private static Item line(DrawnItem item, boolean isClosed, int[] units) {
    int last = units.length - 2;
    boolean repeatsFirst =
        isClosed && last > 0 && units[0] == units[last] && units[1] == units[last + 1];
    int[] points = repeatsFirst ? Arrays.copyOf(units, last) : units;
    double widthMm = item.isFilled() ? 0 : Math.max(1.0, item.pen().width()) / UNITS_PER_MM;
    return new Item(item.rgba(), widthMm, isClosed, "", world(points, 0));
  }

  private static int[] ellipse(int[] n) {
    int[] corners = new int[2 * CORNERS_OF_ELLIPSE];
    for (int i = 0; i < CORNERS_OF_ELLIPSE; i++) {
      double angle = 2 * Math.PI * i / CORNERS_OF_ELLIPSE;
      corners[2 * i] = (int) (n[2] + n[0] * StrictMath.cos(angle));
      corners[2 * i + 1] = (int) (n[3] + n[1] * StrictMath.sin(angle));
    }
    return corners;
  }

  /** A line for each part of the path; a curve becomes the line between its ends. */
  private static void addPath(List<Item> items, DrawnItem item) {
    int[] n = item.numbers();
    List<Integer> points = new ArrayList<>();
    for (int i = 0; i < n.length; ) {
      int count =
          switch (n[i]) {
            case PathIterator.SEG_CLOSE -> 0;
            case PathIterator.SEG_QUADTO -> 2;
            case PathIterator.SEG_CUBICTO -> 3;
            default -> 1;
          };
      boolean ends = count == 0 || n[i] == PathIterator.SEG_MOVETO;
      if (ends && points.size() > 2) {
        items.add(line(item, count == 0, points.stream().mapToInt(v -> v).toArray()));
      }
      if (ends) {
        points.clear();
      }
      i += 1 + 2 * count;
      if (count > 0) {
        points.add(n[i - 2]);
        points.add(n[i - 1]);
      }
    }
    if (points.size() > 2) {
      items.add(line(item, item.isFilled(), points.stream().mapToInt(v -> v).toArray()));
    }
  }

  private static double[] world(int[] units, int from) {
    double[] xyMm = new double[units.length - from];
    for (int i = 0; i < xyMm.length; i++) {
      double px = (double) units[from + i] / UNITS_PER_MM;
      xyMm[i] = i % 2 == 0 ? px - 1 : 1 - px;
    }
    return xyMm;
  }
}

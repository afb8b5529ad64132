package org.starl.apps.lightpaint.view;

import com.github.weisj.jsvg.SVGDocument;
import com.github.weisj.jsvg.parser.LoaderContext;
import com.github.weisj.jsvg.parser.SVGLoader;
import com.github.weisj.jsvg.parser.resources.ResourcePolicy;
import com.github.weisj.jsvg.renderer.NullPlatformSupport;
import com.github.weisj.jsvg.renderer.output.Output;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.starl.apps.lightpaint.logic.Flattened;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/**
 * Reads SVG drawings with JSVG: whatever a browser would draw with a stroke becomes lines, in the
 * order of the file, with groups, transforms, styles and view boxes applied. Fills, pictures,
 * opacity, dashes, clips and masks are not looked at: a line is painted whole or not at all.
 */
public final class SvgDrawing {

  // JSVG tells what it does not like; SvgCheck has told it before, with the line.
  private static final Logger LIBRARY = Logger.getLogger("com.github.weisj.jsvg");

  private static final double MAX_MM = 1e6;

  private final String file;
  private final double mmPerUnit;
  private final double flatnessMm;
  private final double heightUnits;
  private final List<Line> lines = new ArrayList<>();

  private SvgDrawing(String file, double mmPerUnit, double flatnessMm, double heightUnits) {
    this.file = file;
    this.mmPerUnit = mmPerUnit;
    this.flatnessMm = flatnessMm;
    this.heightUnits = heightUnits;
  }

  /**
   * The lines of a file, its lower left corner in the floor's origin, y upwards.
   *
   * @param file its name, for errors
   * @param mmPerUnit millimetres to a unit (a pixel) of the drawing
   * @param flatnessMm no point of a curve is farther from the lines that take its place
   * @throws BadInput if it is no SVG, or something in it cannot be read; the message names the line
   */
  public static List<Line> read(String file, byte[] bytes, double mmPerUnit, double flatnessMm) {
    SvgCheck.check(file, bytes);
    LIBRARY.setLevel(Level.OFF);
    LoaderContext context =
        LoaderContext.builder().externalResourcePolicy(ResourcePolicy.DENY_ALL).build();
    SVGDocument document = new SVGLoader().load(new ByteArrayInputStream(bytes), null, context);
    if (document == null) {
      throw new BadInput(file + ": cannot be drawn: expected an SVG drawing");
    }
    double height = document.size().getHeight();
    SvgDrawing drawing = new SvgDrawing(file, mmPerUnit, flatnessMm, height);
    // Nothing is drawn on it: it keeps transforms, strokes and colours.
    Graphics2D desk = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
    Output output = RecordingOutput.over(Output.createForGraphics(desk), drawing::drawn);
    document.renderWithPlatform(NullPlatformSupport.INSTANCE, output, null);
    desk.dispose();
    return List.copyOf(drawing.lines);
  }

  private void drawn(Shape shape, AffineTransform toUnits, BasicStroke stroke, Paint paint) {
    AffineTransform toMm = new AffineTransform(mmPerUnit, 0, 0, -mmPerUnit, 0, 0);
    toMm.translate(0, -heightUnits);
    toMm.concatenate(toUnits);
    double factor = Math.sqrt(Math.abs(toMm.getDeterminant()));
    double widthMm = Math.max(1, Math.rint(stroke.getLineWidth() * factor));
    int rgb = paint instanceof Color colour ? colour.getRGB() & Ink.MAX_RGB : 0;
    Ink ink = new Ink(rgb, widthMm);
    List<Point> points = new ArrayList<>();
    double[] at = new double[6];
    PathIterator path = shape.getPathIterator(toMm, flatnessMm / 2);
    for (; !path.isDone(); path.next()) {
      int kind = path.currentSegment(at);
      if (kind == PathIterator.SEG_MOVETO) {
        finish(points, ink);
      }
      points.add(kind == PathIterator.SEG_CLOSE ? points.get(0) : new Point(at[0], at[1]));
      if (kind == PathIterator.SEG_CLOSE) {
        Point start = points.get(0);
        finish(points, ink);
        points.add(start);
      }
    }
    finish(points, ink);
  }

  private void finish(List<Point> points, Ink ink) {
    for (Point point : points) {
      if (!point.isFinite() || Math.abs(point.xMm()) > MAX_MM || Math.abs(point.yMm()) > MAX_MM) {
        throw new BadInput(file + ": a line goes to " + point + ": expected within 1 km");
      }
    }
    List<Point> flat = Flattened.of(points, flatnessMm / 2);
    if (flat.size() > 1) {
      lines.add(new Line(new Polyline(flat), ink));
    }
    points.clear();
  }
}

package org.starl.apps.lightpaint.view;

import com.github.weisj.jsvg.SVGDocument;
import com.github.weisj.jsvg.parser.LoaderContext;
import com.github.weisj.jsvg.parser.SVGLoader;
import com.github.weisj.jsvg.parser.resources.ResourcePolicy;
import com.github.weisj.jsvg.renderer.NullPlatformSupport;
import com.github.weisj.jsvg.renderer.output.Output;
import com.github.weisj.jsvg.renderer.output.impl.Graphics2DOutput;
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
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/**
 * Reads SVG drawings with JSVG: all that a browser would draw with a stroke becomes lines, in the
 * order of the file, with groups, transforms, styles and view boxes applied. Fills, images,
 * opacity, dashes, clips and masks are ignored: a line is painted whole or not at all.
 */
public final class SvgDrawing {

  // JSVG logs what it cannot read; SvgCheck has reported that before, with the line.
  private static final Logger LIBRARY = Logger.getLogger("com.github.weisj.jsvg");

  private static final double MAX_MM = 1e6;

  private final String file;
  private final AffineTransform unitsToMm;
  private final double flatnessMm;
  private final List<Line> lines = new ArrayList<>();

  private SvgDrawing(String file, AffineTransform unitsToMm, double flatnessMm) {
    this.file = file;
    this.unitsToMm = unitsToMm;
    this.flatnessMm = flatnessMm;
  }

  /**
   * The lines of a file; its lower left corner is the floor's origin, y upwards.
   *
   * @param file its name, for errors
   * @param mmPerUnit millimetres per unit (pixel) of the drawing
   * @param flatnessMm maximum distance of a curve from the straight lines that replace it
   * @throws BadInput if it is no SVG, or part of it cannot be read; the message names the line
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
    AffineTransform unitsToMm = AffineTransform.getScaleInstance(mmPerUnit, -mmPerUnit);
    unitsToMm.translate(0, -document.size().getHeight());
    SvgDrawing drawing = new SvgDrawing(file, unitsToMm, flatnessMm);
    Graphics2D unused = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
    document.renderWithPlatform(NullPlatformSupport.INSTANCE, drawing.new Recorder(unused), null);
    unused.dispose();
    return List.copyOf(drawing.lines);
  }

  /** Records outlines, with the transforms, strokes and colours that JSVG sets; ignores clips. */
  private final class Recorder extends Graphics2DOutput {

    Recorder(Graphics2D graphics) {
      super(graphics);
    }

    @Override
    public void drawShape(Shape shape) {
      if (stroke() instanceof BasicStroke stroke) {
        drawn(shape, transform(), stroke, graphics().getPaint());
      }
    }

    @Override
    public Output createChild() {
      return new Recorder((Graphics2D) graphics().create());
    }

    @Override
    public boolean supportsFilters() {
      return false;
    }

    @Override
    public void applyClip(Shape clip) {}

    @Override
    public void setClip(Shape clip) {}
  }

  private void drawn(Shape shape, AffineTransform toUnits, BasicStroke stroke, Paint paint) {
    AffineTransform toMm = new AffineTransform(unitsToMm);
    toMm.concatenate(toUnits);
    double scale = Math.sqrt(Math.abs(toMm.getDeterminant()));
    int rgb = paint instanceof Color colour ? colour.getRGB() & Ink.MAX_RGB : 0;
    Ink ink = new Ink(rgb, Math.max(1, Math.rint(stroke.getLineWidth() * scale)));
    List<Point> points = new ArrayList<>();
    double[] at = new double[6];
    PathIterator path = shape.getPathIterator(toMm, flatnessMm / 2);
    for (; !path.isDone(); path.next()) {
      int kind = path.currentSegment(at);
      if (kind == PathIterator.SEG_MOVETO) {
        finish(points, ink, stroke);
        points.clear();
      }
      if (kind == PathIterator.SEG_CLOSE) {
        points.add(points.get(0));
      } else if (Math.abs(at[0]) <= MAX_MM && Math.abs(at[1]) <= MAX_MM) {
        points.add(new Point(at[0], at[1]));
      } else {
        throw new BadInput(
            file + ": a line goes to " + at[0] + ", " + at[1] + " mm: expected within 1 km");
      }
    }
    finish(points, ink, stroke);
  }

  private void finish(List<Point> points, Ink ink, BasicStroke stroke) {
    boolean isSeen =
        stroke.getEndCap() == BasicStroke.CAP_BUTT
            ? Polyline.lengthMm(points) > 0
            : points.size() > 1;
    if (isSeen) {
      List<Point> simple = Polyline.simplified(points, flatnessMm / 2);
      List<Point> whole = Polyline.simplified(simple.stream().map(Polyline::rounded).toList(), 0);
      // A dot: a line of 1 mm.
      Point dot = whole.get(0).plus(new Point(1, 0));
      lines.add(new Line(new Polyline(whole.size() > 1 ? whole : List.of(whole.get(0), dot)), ink));
    }
  }
}

package org.starl.apps.lightpaint.view;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.logic.Flattened;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.geometry.Point;

/**
 * What was truly painted as an SVG drawing, a unit to a millimetre; under it, pale, what was to be
 * painted.
 */
public final class PaintedSvg {

  /** Places are every 10 ms: those that lie on a straight line need not all be there. */
  private static final double FLATNESS_MM = 0.5;

  private final Frame frame;
  private final StringBuilder text = new StringBuilder();

  private PaintedSvg(Frame frame) {
    this.frame = frame;
  }

  /** Writes all of it; {@code out} stays open. */
  public static void write(List<Stroke> strokes, List<Pass> passes, OutputStream out)
      throws IOException {
    PaintedSvg svg = new PaintedSvg(Frame.of(strokes, passes));
    svg.all(strokes, passes);
    out.write(svg.text.toString().getBytes(StandardCharsets.UTF_8));
  }

  private void all(List<Stroke> strokes, List<Pass> passes) {
    text.append(
        String.format(
            Locale.ROOT,
            "<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' height='%.0f'"
                + " viewBox='0 0 %.0f %.0f'>%n",
            frame.widthMm(),
            frame.heightMm(),
            frame.widthMm(),
            frame.heightMm()));
    text.append("<g id='drawing' fill='none' stroke-opacity='0.25'>\n");
    for (Stroke stroke : strokes) {
      line("stroke " + stroke.number(), stroke.path().points(), stroke.ink());
    }
    text.append("</g>\n<g id='painted' fill='none' stroke-linecap='round'>\n");
    for (Pass pass : passes) {
      String what = "stroke " + pass.stroke() + " by " + pass.robot();
      List<Point> points = Flattened.thinned(pass.points(), FLATNESS_MM);
      line(what, points, pass.ink());
    }
    text.append("</g>\n</svg>\n");
  }

  private void line(String what, List<Point> points, Ink ink) {
    text.append(
        String.format(
            Locale.ROOT,
            "<polyline stroke='%s' stroke-width='%.1f' points='",
            ink.colour(),
            ink.widthMm()));
    for (Point point : points) {
      text.append(String.format(Locale.ROOT, "%.1f,%.1f ", frame.x(point), frame.y(point)));
    }
    text.append("'><title>").append(what).append("</title></polyline>\n");
  }
}

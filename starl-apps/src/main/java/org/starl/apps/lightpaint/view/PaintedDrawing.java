package org.starl.apps.lightpaint.view;

import com.github.weisj.jsvg.SVGDocument;
import com.github.weisj.jsvg.parser.LoaderContext;
import com.github.weisj.jsvg.parser.SVGLoader;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import javax.imageio.ImageIO;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** The drawing and what was painted, by true positions, as an SVG file and as a PNG picture. */
public final class PaintedDrawing {

  private static final double MARGIN_MM = 100;
  private static final int PICTURE_PX = 700;
  private static final int TITLE_PX = 34;
  private static final Color PAPER = new Color(0xFA, 0xFA, 0xF7);

  /** A pass has a point every 10 ms: most lie on straight lines. */
  private static final double FLATNESS_MM = 0.5;

  private final List<Stroke> strokes;
  private final List<Pass> passes;
  private final Rectangle frame;
  private final double widthMm;
  private final double heightMm;

  public PaintedDrawing(List<Stroke> strokes, List<Pass> passes) {
    this.strokes = strokes;
    this.passes = passes;
    List<Point> points = new ArrayList<>();
    strokes.forEach(stroke -> points.addAll(stroke.path().points()));
    passes.forEach(pass -> points.addAll(pass.points()));
    frame = Rectangle.around(points).widened(MARGIN_MM);
    widthMm = Math.ceil(frame.xMaxMm() - frame.xMinMm());
    heightMm = Math.ceil(frame.yMaxMm() - frame.yMinMm());
  }

  /** One unit is 1 mm; the drawing is pale, below what was painted. {@code out} stays open. */
  public void writeSvg(OutputStream out) throws IOException {
    out.write(svg(drawing(0.25) + painted()).getBytes(StandardCharsets.UTF_8));
  }

  /** The drawing on the left, what was painted on the right. {@code out} stays open. */
  public void writePng(OutputStream out) throws IOException {
    double pxPerMm = PICTURE_PX / Math.max(widthMm, heightMm);
    int widthPx = (int) Math.ceil(widthMm * pxPerMm);
    int heightPx = (int) Math.ceil(heightMm * pxPerMm);
    BufferedImage image =
        new BufferedImage(2 * widthPx, heightPx + TITLE_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setColor(PAPER);
    page.fillRect(0, 0, image.getWidth(), image.getHeight());
    page.setColor(Color.DARK_GRAY);
    page.drawString("the drawing", 12, 22);
    page.drawString("what was painted, by true positions", widthPx + 12, 22);
    page.drawLine(widthPx, 0, widthPx, image.getHeight());
    page.translate(0, TITLE_PX);
    page.scale(pxPerMm, pxPerMm);
    render(drawing(1), page);
    page.translate(widthPx / pxPerMm, 0);
    render(painted(), page);
    page.dispose();
    ImageIO.write(image, "png", out);
  }

  private void render(String content, Graphics2D page) {
    byte[] bytes = svg(content).getBytes(StandardCharsets.UTF_8);
    LoaderContext context = LoaderContext.createDefault();
    SVGDocument document = new SVGLoader().load(new ByteArrayInputStream(bytes), null, context);
    Objects.requireNonNull(document, "JSVG cannot read the drawing").render(null, page);
  }

  private String svg(String content) {
    return String.format(
        Locale.ROOT,
        "<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' height='%.0f'"
            + " viewBox='0 0 %.0f %.0f'>%n%s</svg>%n",
        widthMm,
        heightMm,
        widthMm,
        heightMm,
        content);
  }

  private String drawing(double opacity) {
    StringBuilder text = new StringBuilder();
    for (Stroke stroke : strokes) {
      append(text, "stroke " + stroke.number(), stroke.path().points(), stroke.ink());
    }
    return "<g id='drawing' fill='none' stroke-opacity='" + opacity + "'>\n" + text + "</g>\n";
  }

  private String painted() {
    StringBuilder text = new StringBuilder();
    for (Pass pass : passes) {
      String title = "stroke " + pass.stroke() + " by " + pass.robot();
      append(text, title, Polyline.simplified(pass.points(), FLATNESS_MM), pass.ink());
    }
    return "<g id='painted' fill='none' stroke-linecap='round'>\n" + text + "</g>\n";
  }

  private void append(StringBuilder text, String title, List<Point> points, Ink ink) {
    text.append(
        String.format(
            Locale.ROOT,
            "<polyline stroke='%s' stroke-width='%.1f' points='",
            ink.colour(),
            ink.widthMm()));
    for (Point point : points) {
      double xMm = point.xMm() - frame.xMinMm();
      double yMm = frame.yMaxMm() - point.yMm();
      text.append(String.format(Locale.ROOT, "%.1f,%.1f ", xMm, yMm));
    }
    text.append("'><title>").append(title).append("</title></polyline>\n");
  }
}

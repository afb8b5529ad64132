package org.starl.apps.lightpaint.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Formatter;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Png;

/** The drawing and what was painted, by true positions, as an SVG file and as a PNG picture. */
public final class PaintedDrawing {

  private static final double MARGIN_MM = 100;
  private static final int PICTURE_PX = 700;
  private static final int TITLE_PX = 34;
  private static final Color PAPER = new Color(0xFA, 0xFA, 0xF7);

  /** A pass has a point every 10 ms: most lie on straight lines. */
  private static final double FLATNESS_MM = 0.5;

  private final List<Mark> drawing = new ArrayList<>();
  private final List<Mark> painted = new ArrayList<>();
  private final Rectangle frame;
  private final double widthMm;
  private final double heightMm;

  private record Mark(String title, List<Point> points, Ink ink) {}

  public PaintedDrawing(List<Stroke> strokes, List<Pass> passes) {
    List<Point> all = new ArrayList<>();
    for (Stroke stroke : strokes) {
      all.addAll(stroke.path().points());
      drawing.add(new Mark("stroke " + stroke.number(), stroke.path().points(), stroke.ink()));
    }
    for (Pass pass : passes) {
      all.addAll(pass.points());
      List<Point> points = Polyline.simplified(pass.points(), FLATNESS_MM);
      painted.add(new Mark("stroke " + pass.stroke() + " by " + pass.robot(), points, pass.ink()));
    }
    frame = Rectangle.around(all).widened(MARGIN_MM);
    widthMm = Math.ceil(frame.xMaxMm() - frame.xMinMm());
    heightMm = Math.ceil(frame.yMaxMm() - frame.yMinMm());
  }

  /** One unit is 1 mm; the drawing is pale, below what was painted. {@code out} stays open. */
  public void writeSvg(OutputStream out) throws IOException {
    Formatter svg = new Formatter(Locale.ROOT);
    svg.format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='%1$.0f' height='%2$.0f'"
            + " viewBox='0 0 %1$.0f %2$.0f'>%n<g id='drawing' fill='none' stroke-opacity='0.25'>%n",
        widthMm, heightMm);
    drawing.forEach(mark -> append(svg, mark));
    svg.format("</g>%n<g id='painted' fill='none' stroke-linecap='round'>%n");
    painted.forEach(mark -> append(svg, mark));
    svg.format("</g>%n</svg>%n");
    out.write(svg.toString().getBytes(StandardCharsets.UTF_8));
  }

  private void append(Formatter svg, Mark mark) {
    Ink ink = mark.ink();
    svg.format("<polyline stroke='%s' stroke-width='%.1f'", ink.colour(), ink.widthMm());
    svg.format(" points='");
    for (Point point : mark.points()) {
      svg.format("%.1f,%.1f ", point.xMm() - frame.xMinMm(), frame.yMaxMm() - point.yMm());
    }
    svg.format("'><title>%s</title></polyline>%n", mark.title());
  }

  /** The drawing on the left, what was painted on the right. {@code out} stays open. */
  public void writePng(OutputStream out) throws IOException {
    double pxPerMm = PICTURE_PX / Math.max(widthMm, heightMm);
    int widthPx = (int) Math.ceil(widthMm * pxPerMm);
    int heightPx = (int) Math.ceil(heightMm * pxPerMm) + TITLE_PX;
    BufferedImage image = new BufferedImage(2 * widthPx, heightPx, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setColor(PAPER);
    page.fillRect(0, 0, 2 * widthPx, heightPx);
    page.setColor(Color.DARK_GRAY);
    page.drawString("the drawing", 12, 22);
    page.drawString("what was painted, by true positions", widthPx + 12, 22);
    page.drawLine(widthPx, 0, widthPx, heightPx);
    page.translate(0, TITLE_PX);
    page.scale(pxPerMm, -pxPerMm);
    page.translate(-frame.xMinMm(), -frame.yMaxMm());
    drawing.forEach(mark -> draw(page, mark));
    page.translate(widthPx / pxPerMm, 0);
    painted.forEach(mark -> draw(page, mark));
    page.dispose();
    Png.write(image, out);
  }

  private static void draw(Graphics2D page, Mark mark) {
    float widthMm = (float) mark.ink().widthMm();
    page.setColor(new Color(mark.ink().rgb()));
    page.setStroke(new BasicStroke(widthMm, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    page.draw(Figures.line(mark.points()));
  }
}

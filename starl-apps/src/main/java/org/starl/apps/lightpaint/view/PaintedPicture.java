package org.starl.apps.lightpaint.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import javax.imageio.ImageIO;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.geometry.Point;

/** What was to be painted, and beside it what was truly painted, as a picture. */
public final class PaintedPicture {

  private static final int SIDE_PX = 700;
  private static final int HEAD_PX = 34;
  private static final Color PAPER = new Color(0xFA, 0xFA, 0xF7);
  private static final Color TEXT = new Color(0x22, 0x22, 0x22);

  private final Frame frame;
  private final double pxPerMm;
  private final Graphics2D page;

  private PaintedPicture(Frame frame, double pxPerMm, Graphics2D page) {
    this.frame = frame;
    this.pxPerMm = pxPerMm;
    this.page = page;
  }

  /** Writes a PNG; {@code out} stays open. */
  public static void write(List<Stroke> strokes, List<Pass> passes, OutputStream out)
      throws IOException {
    Frame frame = Frame.of(strokes, passes);
    double pxPerMm = SIDE_PX / Math.max(frame.widthMm(), frame.heightMm());
    int widthPx = (int) Math.ceil(frame.widthMm() * pxPerMm);
    int heightPx = (int) Math.ceil(frame.heightMm() * pxPerMm);
    BufferedImage image =
        new BufferedImage(2 * widthPx, heightPx + HEAD_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    page.setColor(PAPER);
    page.fillRect(0, 0, image.getWidth(), image.getHeight());
    page.setColor(TEXT);
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
    page.drawString("the drawing", 12, 22);
    page.drawString("what was painted, by true positions", widthPx + 12, 22);
    page.drawLine(widthPx, 0, widthPx, image.getHeight());
    PaintedPicture picture = new PaintedPicture(frame, pxPerMm, page);
    page.translate(0, HEAD_PX);
    for (Stroke stroke : strokes) {
      picture.line(stroke.path().points(), stroke.ink());
    }
    page.translate(widthPx, 0);
    for (Pass pass : passes) {
      picture.line(pass.points(), pass.ink());
    }
    page.dispose();
    ImageIO.write(image, "png", out);
  }

  private void line(List<Point> points, Ink ink) {
    Path2D path = new Path2D.Double();
    path.moveTo(pxPerMm * frame.x(points.get(0)), pxPerMm * frame.y(points.get(0)));
    for (Point point : points) {
      path.lineTo(pxPerMm * frame.x(point), pxPerMm * frame.y(point));
    }
    float widthPx = (float) Math.max(1, pxPerMm * ink.widthMm());
    page.setColor(new Color(ink.rgb()));
    page.setStroke(new BasicStroke(widthPx, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    page.draw(path);
  }
}

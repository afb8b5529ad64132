package org.starl.sim.view.page;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.GradientPaint;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Image;
import java.awt.Paint;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.awt.image.BufferedImageOp;
import java.awt.image.ImageObserver;
import java.awt.image.RenderedImage;
import java.awt.image.renderable.RenderableImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.text.AttributedCharacterIterator;
import java.text.CharacterIterator;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import org.apache.xmlgraphics.java2d.AbstractGraphics2D;
import org.apache.xmlgraphics.java2d.GraphicContext;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Png;
import org.starl.sim.view.page.DrawnItem.Pen;

/**
 * Records drawing operations as {@link DrawnItem}s, in pixels of the page, so that a browser can
 * repeat them. Shapes, strokes, text and images are recorded; clips, gradients and XOR are not
 * supported: a clip is ignored, a gradient becomes its first colour.
 */
final class ShapeRecorder extends AbstractGraphics2D {

  private static final int UNITS_PER_PX = 10;

  private final List<DrawnItem> items;
  private final Graphics2D metrics;

  /**
   * @param items to add to
   */
  ShapeRecorder(List<DrawnItem> items) {
    super(false);
    this.items = items;
    metrics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
    Painter.smooth(metrics);
    gc = new GraphicContext();
    setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
  }

  private ShapeRecorder(ShapeRecorder from) {
    super(from);
    items = from.items;
    metrics = from.metrics;
  }

  @Override
  public Graphics create() {
    return new ShapeRecorder(this);
  }

  @Override
  public void fill(Shape shape) {
    add(shape, Pen.NONE);
  }

  @Override
  public void draw(Shape shape) {
    if (getStroke() instanceof BasicStroke line) {
      add(shape, pen(line));
    } else {
      add(getStroke().createStrokedShape(shape), Pen.NONE);
    }
  }

  /** {@code width cap join dash gap ...} in tenths of a pixel. */
  private Pen pen(BasicStroke line) {
    double scale = Math.sqrt(Math.abs(getTransform().getDeterminant()));
    StringBuilder pen = new StringBuilder();
    int width = units(line.getLineWidth() * scale);
    pen.append(width);
    pen.append(' ').append(line.getEndCap()).append(' ').append(line.getLineJoin());
    float[] dashes = line.getDashArray();
    for (int i = 0; dashes != null && i < dashes.length; i++) {
      pen.append(' ').append(units(dashes[i] * scale));
    }
    return new Pen(width, pen.toString());
  }

  private void add(Shape shape, Pen pen) {
    AffineTransform transform = getTransform();
    boolean isUpright = transform.getShearX() == 0 && transform.getShearY() == 0;
    if (shape instanceof Ellipse2D ellipse && isUpright) {
      Point2D centre = point(ellipse.getCenterX(), ellipse.getCenterY());
      add(
          DrawnItem.ELLIPSE,
          pen,
          "",
          units(ellipse.getWidth() / 2 * Math.abs(transform.getScaleX())),
          units(ellipse.getHeight() / 2 * Math.abs(transform.getScaleY())),
          units(centre.getX()),
          units(centre.getY()));
    } else {
      new Outline(shape.getPathIterator(transform)).addTo(pen);
    }
  }

  /** The segments of a shape. */
  private final class Outline {
    private int[] numbers = new int[64];
    private int size;
    private int moves;
    private int closes;
    private boolean isStraight = true;

    Outline(PathIterator path) {
      double[] xy = new double[6];
      for (; !path.isDone(); path.next()) {
        int segment = path.currentSegment(xy);
        int points =
            switch (segment) {
              case PathIterator.SEG_CLOSE -> 0;
              case PathIterator.SEG_QUADTO -> 2;
              case PathIterator.SEG_CUBICTO -> 3;
              default -> 1;
            };
        moves += segment == PathIterator.SEG_MOVETO ? 1 : 0;
        closes += segment == PathIterator.SEG_CLOSE ? 1 : 0;
        isStraight &= points < 2 && closes <= (segment == PathIterator.SEG_CLOSE ? 1 : 0);
        append(segment);
        for (int i = 0; i < 2 * points; i++) {
          append(units(xy[i]));
        }
      }
    }

    private void append(int number) {
      if (size == numbers.length) {
        numbers = Arrays.copyOf(numbers, 2 * size);
      }
      numbers[size++] = number;
    }

    void addTo(Pen pen) {
      if (size == 0) {
        return;
      }
      if (moves != 1 || !isStraight) {
        add(DrawnItem.PATH, pen, "", Arrays.copyOf(numbers, size));
        return;
      }
      int[] points = new int[(size - closes) / 3 * 2];
      for (int i = 0; i < points.length / 2; i++) {
        points[2 * i] = numbers[3 * i + 1];
        points[2 * i + 1] = numbers[3 * i + 2];
      }
      add(closes == 0 ? DrawnItem.LINE : DrawnItem.POLYGON, pen, "", points);
    }
  }

  private void add(int kind, Pen pen, String text, int... numbers) {
    float share = getComposite() instanceof AlphaComposite alpha ? alpha.getAlpha() : 1;
    int opacity = Math.round(share * getColor().getAlpha());
    int rgba = (opacity << 24) | (getColor().getRGB() & 0xFFFFFF);
    items.add(new DrawnItem(kind, rgba, pen, text, numbers));
  }

  private Point2D point(double x, double y) {
    return getTransform().transform(new Point2D.Double(x, y), null);
  }

  private static int units(double px) {
    return (int) Math.round(UNITS_PER_PX * px);
  }

  @Override
  public void drawString(String text, float x, float y) {
    if (text.isEmpty()) {
      return;
    }
    AffineTransform transform = getTransform();
    Font font = getFont();
    double scale = Math.sqrt(Math.abs(transform.getDeterminant()));
    double angle = StrictMath.atan2(transform.getShearY(), transform.getScaleX());
    Point2D start = point(x, y);
    String pen =
        String.format(
            Locale.ROOT,
            "%s%s%.1fpx %s %.3f",
            font.isItalic() ? "italic " : "",
            font.isBold() ? "bold " : "",
            font.getSize2D() * scale,
            font.getFamily().equals(Font.MONOSPACED) ? "monospace" : "sans-serif",
            angle);
    double width = font.getStringBounds(text, metrics.getFontRenderContext()).getWidth();
    add(
        DrawnItem.TEXT,
        new Pen(0, pen),
        text,
        units(width * scale),
        units(start.getX()),
        units(start.getY()));
  }

  @Override
  public void drawString(AttributedCharacterIterator text, float x, float y) {
    StringBuilder plain = new StringBuilder();
    for (char c = text.first(); c != CharacterIterator.DONE; c = text.next()) {
      plain.append(c);
    }
    drawString(plain.toString(), x, y);
  }

  @Override
  public boolean drawImage(
      Image image, int x, int y, int width, int height, @Nullable ImageObserver observer) {
    BufferedImage copy =
        new BufferedImage(
            Math.max(1, image.getWidth(null)),
            Math.max(1, image.getHeight(null)),
            BufferedImage.TYPE_INT_ARGB);
    Graphics2D painting = copy.createGraphics();
    painting.drawImage(image, 0, 0, null);
    painting.dispose();
    Rectangle at =
        getTransform().createTransformedShape(new Rectangle(x, y, width, height)).getBounds();
    add(
        DrawnItem.IMAGE,
        Pen.NONE,
        address(copy),
        units(at.width),
        units(at.height),
        units(at.x),
        units(at.y));
    return true;
  }

  private static String address(BufferedImage image) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      Png.write(image, bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return "data:image/png;base64," + Base64.getEncoder().encodeToString(bytes.toByteArray());
  }

  @Override
  public boolean drawImage(Image image, int x, int y, @Nullable ImageObserver observer) {
    return drawImage(image, x, y, image.getWidth(null), image.getHeight(null), observer);
  }

  @Override
  public void drawImage(BufferedImage image, @Nullable BufferedImageOp filter, int x, int y) {
    drawImage(filter == null ? image : filter.filter(image, null), x, y, null);
  }

  @Override
  public void drawRenderedImage(RenderedImage image, AffineTransform to) {
    throw unsupported("a RenderedImage");
  }

  @Override
  public void drawRenderableImage(RenderableImage image, AffineTransform to) {
    throw unsupported("a RenderableImage");
  }

  private static UnsupportedOperationException unsupported(String shape) {
    return new UnsupportedOperationException(
        "a layer drew "
            + shape
            + ": expected shapes, text and whole images, which a page can show");
  }

  @Override
  public void copyArea(int x, int y, int width, int height, int dx, int dy) {
    throw unsupported("a copied area");
  }

  @Override
  public void setPaint(Paint paint) {
    super.setPaint(paint instanceof GradientPaint gradient ? gradient.getColor1() : paint);
  }

  // Painters set back a hint that was unset; the base takes no null.
  @Override
  public void setRenderingHint(RenderingHints.Key key, @Nullable Object value) {
    if (value != null) {
      super.setRenderingHint(key, value);
    }
  }

  @Override
  public FontMetrics getFontMetrics(Font wanted) {
    return metrics.getFontMetrics(wanted);
  }

  @Override
  public FontRenderContext getFontRenderContext() {
    return metrics.getFontRenderContext();
  }

  @Override
  public GraphicsConfiguration getDeviceConfiguration() {
    return metrics.getDeviceConfiguration();
  }

  // The page shows the whole floor.
  @Override
  public @Nullable Shape getClip() {
    return null;
  }

  @Override
  public @Nullable Rectangle getClipBounds() {
    return null;
  }

  @Override
  public void setXORMode(Color other) {
    // Paints in the present colour.
  }

  @Override
  public void dispose() {
    // Holds no resources.
  }
}

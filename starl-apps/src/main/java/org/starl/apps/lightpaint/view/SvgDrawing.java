package org.starl.apps.lightpaint.view;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Paint;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.apache.batik.anim.dom.SVGOMAnimatedPathData;
import org.apache.batik.anim.dom.SVGOMPathElement;
import org.apache.batik.bridge.Bridge;
import org.apache.batik.bridge.BridgeContext;
import org.apache.batik.bridge.BridgeException;
import org.apache.batik.bridge.ErrorConstants;
import org.apache.batik.bridge.ExternalResourceSecurity;
import org.apache.batik.bridge.GVTBuilder;
import org.apache.batik.bridge.GraphicsNodeBridge;
import org.apache.batik.bridge.Messages;
import org.apache.batik.bridge.NoLoadExternalResourceSecurity;
import org.apache.batik.bridge.SVGPathElementBridge;
import org.apache.batik.bridge.SVGTextElementBridge;
import org.apache.batik.bridge.SVGUseElementBridge;
import org.apache.batik.bridge.UserAgentAdapter;
import org.apache.batik.dom.svg.LiveAttributeException;
import org.apache.batik.dom.util.XLinkSupport;
import org.apache.batik.ext.awt.MultipleGradientPaint;
import org.apache.batik.gvt.CompositeGraphicsNode;
import org.apache.batik.gvt.CompositeShapePainter;
import org.apache.batik.gvt.FillShapePainter;
import org.apache.batik.gvt.GraphicsNode;
import org.apache.batik.gvt.MarkerShapePainter;
import org.apache.batik.gvt.ProxyGraphicsNode;
import org.apache.batik.gvt.ShapeNode;
import org.apache.batik.gvt.ShapePainter;
import org.apache.batik.gvt.StrokeShapePainter;
import org.apache.batik.parser.ParseException;
import org.apache.batik.parser.PathParser;
import org.apache.batik.util.ParsedURL;
import org.apache.batik.util.SVGConstants;
import org.apache.batik.util.io.StringNormalizingReader;
import org.jspecify.annotations.Nullable;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.w3c.dom.DOMException;
import org.w3c.dom.Element;
import org.w3c.dom.svg.SVGSVGElement;

/**
 * An SVG drawing, read with Apache Batik: all that a browser would draw with a stroke becomes lines,
 * in the order of painting. A line is painted whole or not at all.
 *
 * @param notes what a browser would draw, and is not painted so: {@code FILE:LINE: text}
 */
public record SvgDrawing(List<Line> lines, List<String> notes) {

  private static final double MAX_MM = 1e6;

  private static final double MM_PER_PX = 25.4 / 96;
  private static final float BROWSERS_EM_PX = 16;

  private static final String NUMBER = "[+-]?(?:\\d*\\.)?\\d+(?:[eE][+-]?\\d+)?";
  private static final Pattern BOX = Pattern.compile("(?:%s[\\s,]+){3}%<s".formatted(NUMBER));
  private static final Pattern LENGTH = Pattern.compile("\\s*(" + NUMBER + ")([a-z]*)\\s*");
  private static final Set<String> REAL = Set.of("mm", "cm", "in", "pt", "pc");
  private static final Pattern QUOTED = Pattern.compile("\"([^\"]+)\"");
  private static final Set<String> VIEWPORTS = Set.of("svg", "symbol", "marker");

  /**
   * How a drawing is read.
   *
   * @param mmPerUnit millimetres per unit (pixel)
   * @param isScaled whether a drawing whose size is in mm, cm, in, pt or pc has {@code mmPerUnit},
   *     too, instead of its size
   * @param flatnessMm maximum distance of a curve from the straight lines that replace it
   * @param hasOutlines whether the outlines of shapes that are only filled are lines
   */
  public record Reading(
      double mmPerUnit, boolean isScaled, double flatnessMm, boolean hasOutlines) {}

  /**
   * The lines of a file; its lower left corner is the floor's origin, y upwards.
   *
   * @param file its name, for errors
   * @throws BadInput if it is no SVG, or part of it cannot be read; the message names the line
   */
  public static SvgDrawing read(String file, byte[] bytes, Reading reading) {
    SvgFile svg = new SvgFile(file, bytes);
    Messages.setLocale(Locale.ROOT);
    Context context = new Context(svg);
    SVGSVGElement root = svg.drawing().getRootElement();
    try {
      svg.checkStyles();
      if (root.hasAttribute("transform")) {
        throw svg.bad(svg.line(root), "<svg> with a transform", "it in a <g>");
      }
      boolean isReal = size(svg, root);
      double mmPerUnit = isReal && !reading.isScaled() ? MM_PER_PX : reading.mmPerUnit();
      GraphicsNode all = new GVTBuilder().build(context, svg.drawing());
      AffineTransform toMm = AffineTransform.getScaleInstance(mmPerUnit, -mmPerUnit);
      toMm.translate(0, -context.getDocumentSize().getHeight());
      Walk walk = new Walk(svg, context, reading, mmPerUnit);
      walk.node(all, root, toMm);
      return new SvgDrawing(List.copyOf(walk.lines), svg.notes());
    } catch (BridgeException e) {
      throw bad(svg, e);
    } catch (BadInput e) {
      throw e;
    } catch (RuntimeException | StackOverflowError e) {
      // Batik's parsers and painters throw exceptions of many kinds, and follow rings of links.
      throw svg.bad(
          svg.line(svg.built),
          SvgFile.tag(svg.built) + " cannot be drawn",
          "values of SVG 1.1, and no link in a ring");
    } finally {
      context.dispose();
    }
  }

  private static BadInput bad(SvgFile svg, BridgeException error) {
    Element element =
        Objects.requireNonNullElse(error.getElement(), svg.drawing().getRootElement());
    Matcher quoted = QUOTED.matcher(String.valueOf(error.getMessage()));
    String name = quoted.find() ? quoted.group(1) : "";
    String value = element.getAttribute(name);
    String tag = "<" + element.getLocalName() + "> ";
    if (error.getCode().equals(ErrorConstants.ERR_ATTRIBUTE_MISSING)) {
      return svg.bad(svg.line(element), tag + "without " + name, SvgFile.expected(name));
    }
    if (value.isEmpty()) {
      String link = element.getAttributeNS(SVGConstants.XLINK_NAMESPACE_URI, "href");
      String target = link.isEmpty() ? name.replaceFirst("^file:/+", "") : link;
      return svg.bad(
          svg.line(element),
          tag + "refers to " + BadInput.quote(target),
          "an element of the drawing, such as #a");
    }
    String problem = tag + "with " + name + "=" + BadInput.quote(value);
    if (name.equals("d")) {
      int at = new PathCheck().firstWrong(value);
      problem = "path, character " + (at + 1) + ", at " + BadInput.quote(value.substring(at));
    }
    String least = error.getCode().equals(ErrorConstants.ERR_LENGTH_NEGATIVE) ? ", at least 0" : "";
    return svg.bad(svg.line(element), problem, SvgFile.expected(name) + least);
  }

  /**
   * Gives the drawing the size that it has where a browser shows it whole.
   *
   * @return whether it has one in mm, cm, in, pt or pc
   */
  private static boolean size(SvgFile svg, SVGSVGElement root) {
    String viewBox = root.getAttribute("viewBox").trim();
    double[] page = {300, 150};
    if (!viewBox.isEmpty()) {
      String[] box = BOX.matcher(viewBox).matches() ? viewBox.split("[\\s,]+", -1) : new String[4];
      for (int i = 0; i < 2; i++) {
        page[i] = box[i + 2] == null ? 0 : Double.parseDouble(box[i + 2]);
        if (!(page[i] > 0)) {
          String problem = "viewBox=" + BadInput.quote(viewBox);
          throw svg.bad(svg.line(root), problem, SvgFile.expected("viewBox"));
        }
      }
    }
    boolean isReal = false;
    double perUnit = 1;
    String unit = "";
    List<String> missing = new ArrayList<>();
    for (String side : List.of("width", "height")) {
      Matcher length = LENGTH.matcher(root.getAttribute(side));
      if (root.getAttribute(side).isEmpty() || root.getAttribute(side).endsWith("%")) {
        missing.add(side);
      } else if (length.matches()) {
        unit = length.group(2);
        isReal |= REAL.contains(unit);
        perUnit = Double.parseDouble(length.group(1)) / page[side.equals("width") ? 0 : 1];
        if (perUnit == 0) {
          throw svg.bad(svg.line(root), side + "=0", "a size above 0");
        }
      }
    }
    for (String side : missing) {
      double size = page[side.equals("width") ? 0 : 1];
      root.setAttribute(side, viewBox.isEmpty() ? size + "" : size * perUnit + unit);
    }
    return isReal;
  }

  /** Batik's view of a file: it loads nothing, runs nothing, and asks for no font. */
  private static final class Context extends BridgeContext {

    private final SvgFile svg;

    Context(SvgFile svg) {
      super(
          new UserAgentAdapter() {
            @Override
            public String getMedia() {
              return "screen";
            }

            @Override
            public float getMediumFontSize() {
              return BROWSERS_EM_PX;
            }

            @Override
            public void displayError(Exception error) {
              if (!svg.isChecked() && error instanceof DOMException wrong) {
                throw wrong;
              }
              Matcher name = QUOTED.matcher(String.valueOf(error.getMessage()));
              String what = name.find() ? name.group(1) : "a style sheet outside of the file";
              String value = name.find() ? "=" + BadInput.quote(name.group(1)) : "";
              svg.note(svg.line(svg.built), what + value + " is not applied");
            }

            @Override
            public ExternalResourceSecurity getExternalResourceSecurity(
                ParsedURL resource, ParsedURL document) {
              return new NoLoadExternalResourceSecurity();
            }
          });
      this.svg = svg;
      setDynamicState(INTERACTIVE);
      setDocument(svg.drawing());
      initializeDocument(svg.drawing());
    }

    @Override
    public void registerSVGBridges() {
      super.registerSVGBridges();
      putBridge(
          new SVGPathElementBridge() {
            @Override
            protected void buildShape(BridgeContext context, Element path, ShapeNode node) {
              try {
                SVGOMAnimatedPathData d = ((SVGOMPathElement) path).getAnimatedPathData();
                d.check();
                node.setShape(PathShape.of(d.getAnimatedPathSegList()));
              } catch (LiveAttributeException wrong) {
                throw new BridgeException(context, wrong);
              }
            }
          });
      putBridge(
          new SVGUseElementBridge() {
            @Override
            public GraphicsNode createGraphicsNode(BridgeContext context, Element use) {
              String link = XLinkSupport.getXLinkHref(use);
              return link.isEmpty() || isShown(context.getReferencedElement(use, link))
                  ? super.createGraphicsNode(context, use)
                  : new CompositeGraphicsNode();
            }
          });
      putBridge(
          new SVGTextElementBridge() {
            @Override
            public GraphicsNode createGraphicsNode(BridgeContext context, Element text) {
              String words = text.getTextContent().strip();
              throw svg.bad(
                  svg.line(text),
                  "<text> " + BadInput.quote(words),
                  "its outlines as paths: fonts differ");
            }
          });
    }

    /** Whether a copy of it can be seen; Batik fails at copies of what it does not build. */
    private boolean isShown(Element original) {
      Bridge its = super.getBridge(original);
      boolean isBuilt = its instanceof GraphicsNodeBridge node && node.getDisplay(original);
      return isBuilt || original.getLocalName().equals("symbol");
    }

    @Override
    public Bridge getBridge(Element element) {
      svg.built = element;
      if (element.getLocalName().equals("use")) {
        svg.countCopy(element);
      }
      return super.getBridge(element);
    }
  }

  /** Walks Batik's tree in the order of painting. */
  private static final class Walk {

    private final SvgFile svg;
    private final Context context;
    private final Reading reading;
    private final double mmPerUnit;
    private final List<Line> lines = new ArrayList<>();

    Walk(SvgFile svg, Context context, Reading reading, double mmPerUnit) {
      this.svg = svg;
      this.context = context;
      this.reading = reading;
      this.mmPerUnit = mmPerUnit;
    }

    void node(GraphicsNode node, Element parent, AffineTransform parentToMm) {
      Element own = context.getElement(node);
      Element element = Objects.requireNonNullElse(own, parent);
      if (node.getComposite() instanceof AlphaComposite mix && mix.getAlpha() == 0) {
        return;
      }
      noteIf(
          own != null && isCut(node, element),
          element,
          "a clip is not applied: lines are painted whole");
      noteIf(node.getMask() != null, element, "a mask is not applied: lines are painted whole");
      noteIf(node.getFilter() != null, element, "a filter is not applied");
      AffineTransform toMm = new AffineTransform(parentToMm);
      if (node.getTransform() != null) {
        toMm.concatenate(node.getTransform());
      }
      if (node instanceof CompositeGraphicsNode group) {
        for (Object child : group.getChildren()) {
          node((GraphicsNode) child, element, toMm);
        }
      } else if (node instanceof ProxyGraphicsNode proxy) {
        node(proxy.getSource(), element, toMm);
      } else if (node instanceof ShapeNode shape && shape.isVisible()) {
        shape(shape, element, toMm);
      }
    }

    /** Whether its clip may cut something off: that of a viewport does only beyond its edge. */
    private static boolean isCut(GraphicsNode node, Element element) {
      if (node.getClip() == null || !VIEWPORTS.contains(element.getLocalName())) {
        return node.getClip() != null;
      }
      Rectangle2D lines = node.getGeometryBounds();
      return lines != null && !node.getClip().getClipPath().getBounds2D().contains(lines);
    }

    private void noteIf(boolean isTrue, Element element, String text) {
      if (isTrue) {
        svg.note(svg.line(element), text);
      }
    }

    private static List<ShapePainter> parts(@Nullable ShapePainter painter) {
      if (painter instanceof CompositeShapePainter all) {
        return IntStream.range(0, all.getShapePainterCount())
            .mapToObj(all::getShapePainter)
            .flatMap(part -> parts(part).stream())
            .toList();
      }
      return painter == null ? List.of() : List.of(painter);
    }

    private void shape(ShapeNode node, Element element, AffineTransform toMm) {
      List<ShapePainter> parts = parts(node.getShapePainter());
      boolean isStroked =
          parts.stream().anyMatch(part -> part instanceof StrokeShapePainter && seen(part) != null);
      boolean isSeen = parts.stream().anyMatch(part -> seen(part) != null);
      noteIf(!isSeen, element, "a shape without a visible stroke or fill is not painted");
      for (ShapePainter part : parts) {
        Paint paint = seen(part);
        if (part instanceof MarkerShapePainter markers) {
          new Markers(node.getShape(), markers).nodes.forEach(at -> node(at, element, toMm));
        } else if (part instanceof StrokeShapePainter stroke && paint != null) {
          drawn(node.getShape(), element, toMm, paint, (BasicStroke) stroke.getStroke());
        } else if (paint != null && reading.hasOutlines() && !isStroked) {
          drawn(node.getShape(), element, toMm, paint, new BasicStroke());
        } else if (paint != null) {
          noteIf(!node.getShape().getBounds2D().isEmpty(), element, "a fill is not painted");
        }
      }
    }

    private static @Nullable Paint seen(ShapePainter part) {
      Paint paint =
          part instanceof StrokeShapePainter stroke
              ? stroke.getPaint()
              : part instanceof FillShapePainter fill ? fill.getPaint() : null;
      return paint instanceof Color colour && colour.getAlpha() == 0 ? null : paint;
    }

    private void drawn(
        Shape shape, Element element, AffineTransform toMm, Paint paint, BasicStroke stroke) {
      double scale = Math.sqrt(Math.abs(toMm.getDeterminant()));
      if (scale == 0) {
        return;
      }
      noteIf(stroke.getDashArray() != null, element, "dashes are painted without gaps");
      noteIf(!(paint instanceof Color), element, "a gradient or pattern is painted in one colour");
      Color colour =
          paint instanceof MultipleGradientPaint gradient
              ? gradient.getColors()[0]
              : paint instanceof Color one ? one : Color.BLACK;
      boolean isFixed = element.getAttribute("vector-effect").equals("non-scaling-stroke");
      double widthMm = stroke.getLineWidth() * (isFixed ? mmPerUnit : scale);
      if (!(widthMm <= MAX_MM)) {
        throw svg.bad(svg.line(element), "a line is " + widthMm + " mm wide", "at most 1 km");
      }
      Ink ink = new Ink(colour.getRGB() & Ink.MAX_RGB, Math.max(1, Math.rint(widthMm)));
      List<Point> points = new ArrayList<>();
      double[] at = new double[6];
      PathIterator path = shape.getPathIterator(toMm, reading.flatnessMm() / 2);
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
          throw svg.bad(
              svg.line(element), "a line goes to " + at[0] + ", " + at[1] + " mm", "within 1 km");
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
        double flatMm = reading.flatnessMm() / 2;
        List<Point> simple = Polyline.simplified(points, flatMm);
        List<Point> whole = Polyline.simplified(simple.stream().map(Polyline::rounded).toList(), 0);
        // A dot: a line of 1 mm.
        Point dot = whole.get(0).plus(new Point(1, 0));
        lines.add(
            new Line(new Polyline(whole.size() > 1 ? whole : List.of(whole.get(0), dot)), ink));
      }
    }
  }

  /** Counts the characters of a path that Batik's parser reads. */
  private static final class PathCheck extends PathParser {

    private int read;

    int firstWrong(String path) {
      reader =
          new StringNormalizingReader(path) {
            @Override
            public int read() throws IOException {
              read++;
              return super.read();
            }
          };
      try {
        doParse();
        return 0;
      } catch (ParseException | IOException e) {
        return Math.clamp(read - 1, 0, path.length());
      }
    }
  }

  /** The markers of a line, at their places. */
  private static final class Markers extends MarkerShapePainter {

    private final List<GraphicsNode> nodes = new ArrayList<>();

    Markers(Shape line, MarkerShapePainter of) {
      super(line);
      startMarker = of.getStartMarker();
      middleMarker = of.getMiddleMarker();
      endMarker = of.getEndMarker();
      nodes.add(startMarker == null ? null : buildStartMarkerProxy());
      nodes.addAll(middleMarker == null ? List.of() : List.of(buildMiddleMarkerProxies()));
      nodes.add(endMarker == null ? null : buildEndMarkerProxy());
      nodes.removeIf(Objects::isNull);
    }
  }
}

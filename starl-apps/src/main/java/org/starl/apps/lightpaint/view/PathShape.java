package org.starl.apps.lightpaint.view;

import java.awt.Shape;
import org.apache.batik.dom.svg.SVGAnimatedPathDataSupport;
import org.apache.batik.parser.AWTPathProducer;
import org.w3c.dom.svg.SVGPathSegList;

/**
 * The shape of a path. A smooth curve continues a curve of its own kind only, as SVG demands: {@code T}
 * after {@code C}, {@code S} after {@code Q}, and both after {@code Z}, begin without a control point of
 * the curve before. Batik takes that point from any curve.
 */
final class PathShape extends AWTPathProducer {

  private enum Kind {
    CUBIC,
    QUADRATIC,
    OTHER
  }

  private Kind last = Kind.OTHER;

  private PathShape() {}

  static Shape of(SVGPathSegList path) {
    PathShape shape = new PathShape();
    SVGAnimatedPathDataSupport.handlePathSegList(path, shape);
    return shape.getShape();
  }

  private void begin(Kind next) {
    if (next != last) {
      xCenter = currentX;
      yCenter = currentY;
    }
    last = next;
  }

  @Override
  public void curvetoCubicRel(float x1, float y1, float x2, float y2, float x, float y) {
    begin(Kind.CUBIC);
    super.curvetoCubicRel(x1, y1, x2, y2, x, y);
  }

  @Override
  public void curvetoCubicAbs(float x1, float y1, float x2, float y2, float x, float y) {
    begin(Kind.CUBIC);
    super.curvetoCubicAbs(x1, y1, x2, y2, x, y);
  }

  @Override
  public void curvetoCubicSmoothRel(float x2, float y2, float x, float y) {
    begin(Kind.CUBIC);
    super.curvetoCubicSmoothRel(x2, y2, x, y);
  }

  @Override
  public void curvetoCubicSmoothAbs(float x2, float y2, float x, float y) {
    begin(Kind.CUBIC);
    super.curvetoCubicSmoothAbs(x2, y2, x, y);
  }

  @Override
  public void curvetoQuadraticRel(float x1, float y1, float x, float y) {
    begin(Kind.QUADRATIC);
    super.curvetoQuadraticRel(x1, y1, x, y);
  }

  @Override
  public void curvetoQuadraticAbs(float x1, float y1, float x, float y) {
    begin(Kind.QUADRATIC);
    super.curvetoQuadraticAbs(x1, y1, x, y);
  }

  @Override
  public void curvetoQuadraticSmoothRel(float x, float y) {
    begin(Kind.QUADRATIC);
    super.curvetoQuadraticSmoothRel(x, y);
  }

  @Override
  public void curvetoQuadraticSmoothAbs(float x, float y) {
    begin(Kind.QUADRATIC);
    super.curvetoQuadraticSmoothAbs(x, y);
  }

  @Override
  public void closePath() {
    super.closePath();
    begin(Kind.OTHER);
  }
}

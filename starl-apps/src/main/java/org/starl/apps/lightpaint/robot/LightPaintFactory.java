package org.starl.apps.lightpaint.robot;

import java.util.List;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.lightpaint.logic.LightPaintApp;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.PaintFact;
import org.starl.apps.lightpaint.logic.Painting;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.logic.Strokes;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantity;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.trace.Vocabulary;

/** The paper's light painting, of the default drawing. */
public final class LightPaintFactory implements AppFactory {

  public static final Parameter DRAWING =
      new Parameter("drawing", "", "file NAME.svg or NAME.wpt to paint (default: a house)");
  public static final Parameter STARTS =
      new Parameter(
          "starts", "", "file NAME.wpt with the painters' starts (default: beside the drawing)");
  public static final Parameter SCALE =
      new Parameter(
          "scale",
          "5mm",
          "length of a unit (pixel) of an SVG drawing",
          Form.between(Quantity.DISTANCE, "0.001mm", "10m"));
  public static final Parameter FLATNESS =
      new Parameter(
          "flatness",
          "5mm",
          "maximum distance of a curve from the straight lines that replace it",
          Form.between(Quantity.DISTANCE, "1mm", "100mm"));
  public static final Parameter STROKE =
      new Parameter(
          "stroke",
          "1200mm",
          "maximum length of a stroke, which one robot paints",
          Form.between(Quantity.DISTANCE, "100mm", "10m"));

  public static final Parameter FILLS =
      Parameter.choice("fills", "outlines of shapes that are only filled", "leave", "outline");

  /** Every painter votes on every tube and plans around all tubes. */
  private static final int MAX_PAINTERS = 200;

  @Override
  public String name() {
    return "lightpaint";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(DRAWING, STARTS, SCALE, FILLS, FLATNESS, STROKE);
  }

  @Override
  public Vocabulary vocabulary(Request request) {
    return PaintFact.VOCABULARY;
  }

  @Override
  public RobotProgram program(Request request) {
    request.refuseOnRobots(DRAWING);
    request.refuseOnRobots(STARTS);
    int painters = request.robots().orElse(1);
    checkPainters(painters);
    List<Stroke> strokes = strokes(request, house(request));
    double radiusMm = Painting.radiusMm(request.motion());
    return program(Painting.of(strokes, List.of(), painters, radiusMm));
  }

  /** The program of the painters of this painting. */
  public static RobotProgram program(Painting painting) {
    return RobotProgram.of(
            gvh -> new LightPaintApp(gvh, painting, painting.homes().get(RobotProgram.number(gvh))))
        .withMonitor(AgreementSpec::new);
  }

  /**
   * @throws BadInput if a painting has not so many painters
   */
  public static void checkPainters(int painters) {
    if (painters < 1 || painters > MAX_PAINTERS) {
      throw new BadInput("robots: " + painters + ": expected 1 to " + MAX_PAINTERS + " painters");
    }
  }

  /** The default drawing, with the flatness of a request. */
  public static List<Line> house(Request request) {
    return HouseDrawing.lines(flatnessMm(request));
  }

  /** The value of {@link #FLATNESS}. */
  public static double flatnessMm(Request request) {
    return request.amount(FLATNESS);
  }

  /**
   * The strokes of a drawing.
   *
   * @param lines at least one
   * @throws BadInput if there are too many
   */
  public static List<Stroke> strokes(Request request, List<Line> lines) {
    double longestMm = request.amount(STROKE);
    List<Stroke> strokes = Strokes.of(lines, 2 * flatnessMm(request), longestMm);
    if (strokes.isEmpty() || strokes.size() > Strokes.MAX) {
      throw new BadInput(
          "drawing="
              + BadInput.quote(request.parameter(DRAWING.key()))
              + ": more than "
              + Strokes.MAX
              + " strokes: expected at most "
              + Strokes.MAX
              + "; change scale or stroke");
    }
    return strokes;
  }
}

package org.starl.apps.lightpaint;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Demo;
import org.starl.apps.Input;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.lightpaint.logic.LightPaintApp;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Painting;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.logic.Strokes;
import org.starl.apps.lightpaint.spec.PaintSpec;
import org.starl.apps.lightpaint.view.LightPaintLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** The paper's section 5.4, Figure 9: {@code starl run lightpaint}. */
public final class LightPaintDemo implements Demo {

  private static final int MAX_PAINTERS = 16;
  private static final int MAX_STROKES = 300;

  /** Without faults and position noise: the goal radius, and the distance driven in a period. */
  private static final double TOLERANCE_MM = 25;

  private static final long BOUND_NS = 600_000_000_000L;
  private static final long BOUND_PER_STROKE_NS = 60_000_000_000L;

  /** Start positions among the original drawings, and the drawing that they belong to. */
  private static final String ORIGINAL_STARTS = "startpoints_benchmark2.wpt";

  private static final String ORIGINAL_OF_STARTS = "benchmark.svg";

  private static final List<String> ORIGINALS =
      List.of(
          ORIGINAL_OF_STARTS,
          "bike.svg",
          "bike.wpt",
          "box.svg",
          "collisiontest.svg",
          "cube.svg",
          "cube2.wpt",
          "curve_parse_test.svg",
          "gaptest.svg",
          "hi.svg",
          "kiva.svg",
          "kiva.wpt",
          "triforce.svg",
          "triforce.wpt");

  private static final Parameter DRAWING =
      new Parameter("drawing", "", "file NAME.svg or NAME.wpt to paint (default: a house)");
  private static final Parameter STARTS =
      new Parameter(
          "starts", "", "file NAME.wpt with the painters' starts (default: beside the drawing)");
  private static final Parameter SCALE =
      new Parameter("scale", "5mm", "millimetres per unit (pixel) of an SVG drawing");
  private static final Parameter FLATNESS =
      new Parameter(
          "flatness", "5mm", "maximum distance of a curve from the straight lines that replace it");
  private static final Parameter STROKE =
      new Parameter("stroke", "1200mm", "maximum length of a stroke, which one robot paints");

  @Override
  public String name() {
    return "lightpaint";
  }

  @Override
  public String summary() {
    return "robots paint a drawing with their lights, in tubes that never meet (paper, section 5.4)";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(DRAWING, STARTS, SCALE, FLATNESS, STROKE);
  }

  @Override
  public List<Input> inputs(Path data) {
    Path folder = data.resolve("starl-original/lightpaint");
    List<Input> inputs = new ArrayList<>();
    for (String name : ORIGINALS) {
      inputs.add(input(folder, name, Map.of(DRAWING.key(), name)));
    }
    Map<String, String> startsAndDrawing =
        Map.of(STARTS.key(), ORIGINAL_STARTS, DRAWING.key(), ORIGINAL_OF_STARTS);
    inputs.add(input(folder, ORIGINAL_STARTS, startsAndDrawing));
    return inputs;
  }

  private static Input input(Path folder, String name, Map<String, String> files) {
    SortedMap<String, String> parameters = new TreeMap<>(files);
    parameters.replaceAll((key, file) -> folder.resolve(file).toString());
    return new Input(name, folder.resolve(name), parameters, "");
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return SimSettings.builder().set(Setting.DURATION, Duration.ofHours(2));
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    int painters = request.robots().orElse(settings.robots());
    if (painters < 1 || painters > MAX_PAINTERS) {
      throw new BadInput("robots: " + painters + ": expected 1 to " + MAX_PAINTERS);
    }
    MotionParameters body = settings.motionParameters(0);
    List<Stroke> strokes = strokes(request);
    double radiusMm = Painting.radiusMm(body);
    String file = request.parameter(STARTS.key());
    List<Point> starts =
        file.isEmpty() ? List.of() : Room.readStarts(path(STARTS, file), painters, radiusMm);
    Room room = Room.around(strokes, starts, painters, radiusMm);
    Painting painting = new Painting(strokes, room.floor());
    LightPaintStory story = new LightPaintStory(painting);
    Simulation.Builder simulation = Simulation.builder().settings(settings).observer(story);
    for (int i = 0; i < painters; i++) {
      RobotId name = new RobotId(settings.robotName() + i);
      Point home = room.homes().get(i);
      Pose start = Pose.of(starts.isEmpty() ? home : starts.get(i), 0);
      simulation.robot(
          new RobotSpec(name, start, true, gvh -> new LightPaintApp(gvh, painting, home)));
    }
    double toleranceMm = toleranceMm(settings, body);
    long boundNs = BOUND_NS + strokes.size() * BOUND_PER_STROKE_NS;
    simulation.monitor(() -> new PaintSpec(strokes, toleranceMm, boundNs));
    simulation.monitor(AgreementSpec::new);
    simulation.monitor(() -> new TubesSpec(boundNs));
    return new Plan(simulation, story, new LightPaintLayer(painting), Obstacles.NONE);
  }

  private static List<Stroke> strokes(Request request) {
    double flatnessMm = mm(request, FLATNESS, 1, 100);
    double scaleMm = mm(request, SCALE, 0.001, 10_000);
    double longestMm = mm(request, STROKE, 100, 10_000);
    String file = request.parameter(DRAWING.key());
    List<Line> lines =
        file.isEmpty()
            ? DrawingFiles.house(flatnessMm)
            : DrawingFiles.read(path(DRAWING, file), scaleMm, flatnessMm);
    List<Stroke> strokes = Strokes.of(lines, 2 * flatnessMm, longestMm);
    if (strokes.isEmpty() || strokes.size() > MAX_STROKES) {
      throw new BadInput(
          "drawing=%s: %d strokes: expected 1 to %d; change that with scale or stroke"
              .formatted(BadInput.quote(file), strokes.size(), MAX_STROKES));
    }
    return strokes;
  }

  private static double toleranceMm(SimSettings settings, MotionParameters body) {
    boolean hasFaults =
        !settings.get(Setting.FAULTS).isEmpty() || settings.get(Setting.CHAOS) != Envelope.NONE;
    double nearMm = TOLERANCE_MM + settings.positionNoise().boundMm();
    return hasFaults ? Math.max(nearMm, Painting.trackMm(body)) : nearMm;
  }

  private static double mm(Request request, Parameter parameter, double least, double most) {
    String text = request.parameter(parameter.key());
    try {
      double mm = Quantities.distanceMm(text);
      if (mm < least || mm > most) {
        throw new BadInput(BadInput.quote(text) + ": expected " + least + "mm to " + most + "mm");
      }
      return mm;
    } catch (BadInput error) {
      throw Quantities.in(parameter.key(), error);
    }
  }

  private static Path path(Parameter parameter, String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new BadInput(parameter.key() + "=" + BadInput.quote(text) + ": expected a file's name");
    }
  }
}

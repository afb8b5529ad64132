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

  /** Beyond positions' noise, in a world without faults: the goal radius, and what is driven in a step. */
  private static final double TOLERANCE_MM = 25;

  private static final long AFTER_ALL_NS = 600_000_000_000L;
  private static final long STROKE_NS = 60_000_000_000L;

  private static final List<String> ORIGINALS =
      List.of(
          "benchmark.svg",
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
      new Parameter("drawing", "", "file NAME.svg or NAME.wpt to paint; a house unless given");
  private static final Parameter STARTS =
      new Parameter(
          "starts", "", "file NAME.wpt of where painters start; beside the drawing unless given");
  private static final Parameter SCALE =
      new Parameter("scale", "5mm", "millimetres to a unit (a pixel) of an SVG drawing");
  private static final Parameter FLATNESS =
      new Parameter(
          "flatness", "5mm", "no point of a curve is farther from the lines that take its place");
  private static final Parameter STROKE =
      new Parameter("stroke", "1200mm", "no robot paints a longer stroke in one go");

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
      inputs.add(input(name, folder.resolve(name), Map.of()));
    }
    Path starts = folder.resolve("startpoints_benchmark2.wpt");
    Path drawing = folder.resolve("benchmark.svg");
    inputs.add(
        input("startpoints_benchmark2.wpt", starts, Map.of(DRAWING.key(), drawing.toString())));
    return inputs;
  }

  private static Input input(String name, Path file, Map<String, String> drawing) {
    SortedMap<String, String> parameters = new TreeMap<>(drawing);
    parameters.put(drawing.isEmpty() ? DRAWING.key() : STARTS.key(), file.toString());
    return new Input(name, file, parameters, "");
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
    String starts = request.parameter(STARTS.key());
    List<Point> given =
        starts.isEmpty() ? List.of() : StartFile.read(path(STARTS, starts), painters, radiusMm);
    Room room = Room.around(strokes, given, painters, radiusMm);
    Painting painting = new Painting(strokes, room.floor());
    LightPaintStory story = new LightPaintStory(painting);
    Simulation.Builder simulation = Simulation.builder().settings(settings).observer(story);
    List<Point> homes = room.places();
    for (int i = 0; i < painters; i++) {
      Point home = homes.get(i);
      Point start = given.isEmpty() ? home : given.get(i);
      simulation.robot(
          new RobotSpec(
              new RobotId(settings.robotName() + i),
              new Pose(start.xMm(), start.yMm(), 0),
              true,
              gvh -> new LightPaintApp(gvh, painting, home)));
    }
    double toleranceMm = toleranceMm(settings, body);
    long boundNs = AFTER_ALL_NS + strokes.size() * STROKE_NS;
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
            ? BuiltIn.house(flatnessMm)
            : DrawingFiles.read(path(DRAWING, file), scaleMm, flatnessMm);
    List<Stroke> strokes = Strokes.of(lines, 2 * flatnessMm, longestMm);
    if (strokes.isEmpty() || strokes.size() > MAX_STROKES) {
      throw new BadInput(
          "drawing="
              + BadInput.quote(file)
              + ": "
              + strokes.size()
              + " strokes: expected 1 to "
              + MAX_STROKES
              + "; scale and stroke change that");
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

package org.starl.apps.lightpaint;

import static org.starl.apps.lightpaint.robot.LightPaintFactory.DRAWING;
import static org.starl.apps.lightpaint.robot.LightPaintFactory.FILLS;
import static org.starl.apps.lightpaint.robot.LightPaintFactory.SCALE;
import static org.starl.apps.lightpaint.robot.LightPaintFactory.STARTS;

import java.io.File;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Input;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.lightpaint.logic.Painting;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.robot.LightPaintFactory;
import org.starl.apps.lightpaint.spec.PaintSpec;
import org.starl.apps.lightpaint.view.LightPaintLayer;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.primitives.paths.TubesSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;
import org.starl.time.Time;

/** The paper's section 5.4, Figure 9: {@code starl run lightpaint}. */
public final class LightPaintDemo implements FactoryDemo {

  /** Without faults and position noise: the goal radius, and the distance driven in a period. */
  private static final double TOLERANCE_MM = 25;

  private static final long BOUND_NS = 600 * Time.NS_PER_S;
  private static final long BOUND_PER_STROKE_NS = 60 * Time.NS_PER_S;

  /** Start positions among the original drawings, and the drawing that they belong to. */
  private static final String ORIGINAL_STARTS = "startpoints_benchmark2.wpt";

  private static final String ORIGINAL_OF_STARTS = "benchmark.svg";

  private static final LightPaintFactory FACTORY = new LightPaintFactory();

  @Override
  public AppFactory factory() {
    return FACTORY;
  }

  @Override
  public String summary() {
    return "robots paint a drawing with their lights, in tubes that never meet"
        + " (paper, section 5.4)";
  }

  @Override
  public List<Input> inputs(Path data) {
    File folder = data.resolve("starl-original/lightpaint").toFile();
    List<Input> inputs = new ArrayList<>();
    for (File file : Objects.requireNonNullElse(folder.listFiles(), new File[0])) {
      SortedMap<String, String> parameters = new TreeMap<>();
      parameters.put(DRAWING.key(), file.toString());
      if (file.getName().equals(ORIGINAL_STARTS)) {
        parameters.put(DRAWING.key(), new File(folder, ORIGINAL_OF_STARTS).toString());
        parameters.put(STARTS.key(), file.toString());
      }
      inputs.add(new Input(file.getName(), file.toPath(), parameters, ""));
    }
    inputs.sort(Comparator.comparing(Input::name));
    return inputs;
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public Request varied(Request request) {
    return request.drawRobots(2, 8);
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return SimSettings.builder().set(Setting.DURATION, Duration.ofHours(2));
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    int painters = request.robots().orElse(settings.robots());
    LightPaintFactory.checkPainters(painters);
    MotionParameters body = settings.motionParameters(0);
    SvgDrawing drawing = drawing(request);
    List<Stroke> strokes = LightPaintFactory.strokes(request, drawing.lines());
    double radiusMm = Painting.radiusMm(body);
    String file = request.parameter(STARTS.key());
    List<Point> starts = file.isEmpty() ? List.of() : readStarts(Path.of(file), painters, radiusMm);
    Painting painting = Painting.of(strokes, starts, painters, radiusMm);
    RobotProgram program = LightPaintFactory.program(painting);
    LightPaintStory story = new LightPaintStory(painting, drawing.notes());
    Simulation.Builder simulation = Simulation.builder().settings(settings).observer(story);
    for (int i = 0; i < painters; i++) {
      RobotId name = new RobotId(settings.robotName() + i);
      Point home = painting.homes().get(i);
      Pose start = Pose.of(starts.isEmpty() ? home : starts.get(i), 0);
      simulation.robot(new RobotSpec(name, start, true, program.app()));
    }
    double toleranceMm = toleranceMm(settings, body);
    long boundNs = BOUND_NS + strokes.size() * BOUND_PER_STROKE_NS;
    simulation.monitor(() -> new PaintSpec(strokes, toleranceMm, boundNs));
    program.monitors().forEach(simulation::monitor);
    simulation.monitor(() -> new TubesSpec(boundNs));
    return new Plan(simulation, story, new LightPaintLayer(painting), Obstacles.NONE);
  }

  private static SvgDrawing drawing(Request request) {
    SvgDrawing.Reading reading =
        new SvgDrawing.Reading(
            request.amount(SCALE),
            request.given().contains(SCALE.key()),
            LightPaintFactory.flatnessMm(request),
            request.choice(FILLS).equals("outline"));
    String file = request.parameter(DRAWING.key());
    return file.isEmpty()
        ? new SvgDrawing(LightPaintFactory.house(request), List.of())
        : DrawingFiles.read(Path.of(file), reading);
  }

  private static double toleranceMm(SimSettings settings, MotionParameters body) {
    double nearMm = TOLERANCE_MM + settings.positionNoise().boundMm();
    return settings.hasFaults() ? Math.max(nearMm, Painting.trackMm(body)) : nearMm;
  }

  /**
   * The starts in a waypoint file, one line for each painter.
   *
   * @throws BadInput if there are fewer than painters, or two tubes at them would meet
   */
  private static List<Point> readStarts(Path file, int painters, double radiusMm) {
    List<Waypoint> starts = WaypointFiles.read(file).waypoints();
    if (starts.size() < painters) {
      throw new BadInput(
          String.format(
              "%s: %s starts: expected one for each of %s painters",
              file, starts.size(), painters));
    }
    double leastMm = 2 * radiusMm + 2;
    List<Point> points = new ArrayList<>();
    for (Waypoint start : starts.subList(0, painters)) {
      Point at = new Point(start.xMm(), start.yMm());
      for (int i = 0; i < points.size(); i++) {
        double mm = points.get(i).distanceMm(at);
        if (mm < leastMm) {
          throw new BadInput(
              "%s: %s and %s are %.0f mm apart: expected at least %.0f"
                  .formatted(file, starts.get(i).name(), start.name(), mm, leastMm));
        }
      }
      points.add(at);
    }
    return points;
  }
}

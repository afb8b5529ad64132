package org.starl.apps.race;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Input;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.race.logic.Drive;
import org.starl.apps.race.logic.RacePoint;
import org.starl.apps.race.logic.Scoreboard;
import org.starl.apps.race.robot.RaceFactory;
import org.starl.apps.race.spec.RaceProgress;
import org.starl.apps.race.spec.RaceSafety;
import org.starl.apps.race.view.RaceLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** The paper's Race App (section 5.4): {@code starl run race}. */
public final class RaceDemo implements FactoryDemo {

  private static final RaceFactory FACTORY = new RaceFactory();

  /** A robot with a larger position error need not deliver a geocast. */
  private static final double POSITION_ERROR_MM = 50;

  /** Robots arrive in it, but it ends before a race does, so that progress is required. */
  private static final Duration CHAOS = Duration.ofSeconds(60);

  /** The side of a box. */
  private static final double BOX_MM = 200;

  @Override
  public AppFactory factory() {
    return FACTORY;
  }

  @Override
  public String summary() {
    return "robots race to the same points; arrivals are broadcast (paper, section 5.4)";
  }

  @Override
  public List<Input> inputs(Path data) {
    Path folder = data.resolve("starl-original/race");
    return List.of(
        input(folder.resolve("four.wpt"), "N=2: 10 of 10, 36 to 80 s; N=64: none within 60 s"),
        input(folder.resolve("four1.wpt"), ""));
  }

  private static Input input(Path file, String original) {
    return new Input(
        String.valueOf(file.getFileName()),
        file,
        new TreeMap<>(Map.of(RaceFactory.POINTS.key(), file.toString())),
        original);
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public Request varied(Request request) {
    return request
        .drawRobots(2, 12)
        .drawParameter(RaceFactory.DRAWN, "10")
        .drawParameter(RaceFactory.BOXES, "2");
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    SimSettings defaults = SimSettings.defaults();
    double more = RaceFactory.floorScale(request);
    return SimSettings.builder()
        .set(Setting.FLOOR_WIDTH, Math.ceil(more * defaults.get(Setting.FLOOR_WIDTH)))
        .set(Setting.FLOOR_HEIGHT, Math.ceil(more * defaults.get(Setting.FLOOR_HEIGHT)));
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    int robots = request.robots().orElse(settings.robots());
    RaceFactory.checkRobots(robots);
    boolean isCut =
        settings.get(Setting.CHAOS) != Envelope.NONE && !settings.has(Setting.CHAOS_FOR);
    List<RacePoint> points = points(request, settings);
    RaceStory story = new RaceStory(points);
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(isCut ? settings.with(Setting.CHAOS_FOR, CHAOS) : settings)
            .obstacles(boxes(points, request.whole(RaceFactory.BOXES)))
            .robots(robots, RaceFactory.program(points).app())
            .observer(story);
    watch(simulation, points, settings);
    return new Plan(simulation, story, new RaceLayer(points), simulation.obstacles());
  }

  /** No robot gets to the first {@code count} points: it wins them from beside a hidden box. */
  private static Obstacles boxes(List<RacePoint> points, int count) {
    List<Obstacle> boxes = new ArrayList<>();
    for (RacePoint point : points.subList(0, Math.min(count, points.size()))) {
      List<Point> corners = Rectangle.around(point.at(), BOX_MM, BOX_MM).corners();
      boxes.add(new Obstacle(corners, true, true, Obstacle.FOREVER));
    }
    return new Obstacles(boxes);
  }

  /** Adds all monitors of a run. */
  static void watch(Simulation.Builder simulation, List<RacePoint> points, SimSettings settings) {
    long delayNs = settings.messageDelay().longestNs();
    double loss = settings.messageLoss().probability();
    double farthestMm = farthestMm(points, settings);
    simulation.monitor(() -> new RaceSafety(points));
    simulation.monitor(() -> new RaceProgress(points, delayNs, loss, farthestMm));
    RacePoint widest =
        points.stream().max(Comparator.comparingDouble(RacePoint::radiusMm)).orElseThrow();
    MotionParameters motion = Drive.motion(settings.motionParameters(0), widest);
    simulation.monitor(() -> new MotionSpec(motion));
    long copyNs = loss == 0 ? delayNs : GeocastSpec.NEVER;
    simulation.monitor(() -> new GeocastSpec(POSITION_ERROR_MM, Scoreboard.SETTINGS, copyNs));
  }

  /** No robot on the floor, or at a point, is farther from any point. */
  private static double farthestMm(List<RacePoint> points, SimSettings settings) {
    List<Point> places = new ArrayList<>();
    points.forEach(point -> places.add(point.at()));
    places.add(new Point(0, 0));
    places.add(new Point(settings.get(Setting.FLOOR_WIDTH), settings.get(Setting.FLOOR_HEIGHT)));
    Rectangle all = Rectangle.around(places);
    return StrictMath.hypot(all.xMaxMm() - all.xMinMm(), all.yMaxMm() - all.yMinMm());
  }

  private List<RacePoint> points(Request request, SimSettings settings) {
    String file = request.parameter(RaceFactory.POINTS.key());
    if (!file.isEmpty()) {
      return RacePoints.read(file);
    }
    return RaceFactory.drawn(
        request, settings.get(Setting.FLOOR_WIDTH), settings.get(Setting.FLOOR_HEIGHT));
  }
}

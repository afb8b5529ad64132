package org.starl.apps.race;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.apps.Demo;
import org.starl.apps.Input;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.race.logic.Drive;
import org.starl.apps.race.logic.RaceApp;
import org.starl.apps.race.logic.RacePoint;
import org.starl.apps.race.logic.Scoreboard;
import org.starl.apps.race.spec.RaceBounds;
import org.starl.apps.race.spec.RaceSpec;
import org.starl.apps.race.view.RaceLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** The paper's section 5.4, Race App: {@code starl run race}. */
public final class RaceDemo implements Demo {

  private static final String XID = "race";
  private static final int MOST_ROBOTS = 64;
  private static final int MOST_DRAWN = 100;

  /** More robots than these get a larger floor. */
  private static final int ROBOTS_ON_DEFAULT_FLOOR = 12;

  /** Robots may know their places worse, and then owe nothing by geocast. */
  private static final double POSITION_ERROR_MM = 50;

  private static final Parameter POINTS =
      new Parameter(
          "points", "", "a .wpt file: the WAY lines are raced to in their order; empty for drawn");
  private static final Parameter DRAWN =
      new Parameter("drawn", "5", "how many points are drawn from the seed, 1 to 100");

  @Override
  public String name() {
    return "race";
  }

  @Override
  public String summary() {
    return "robots race to the same points; arrivals are broadcast (paper, section 5.4)";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(POINTS, DRAWN);
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
        new TreeMap<>(Map.of(POINTS.key(), file.toString())),
        original);
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    SimSettings defaults = SimSettings.defaults();
    double more =
        StrictMath.sqrt(Math.max(1, request.robots().orElse(1) / (double) ROBOTS_ON_DEFAULT_FLOOR));
    return SimSettings.builder()
        .set(Setting.FLOOR_WIDTH, Math.ceil(more * defaults.get(Setting.FLOOR_WIDTH)))
        .set(Setting.FLOOR_HEIGHT, Math.ceil(more * defaults.get(Setting.FLOOR_HEIGHT)));
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    int robots = request.robots().orElse(settings.robots());
    if (robots < 1 || robots > MOST_ROBOTS) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + MOST_ROBOTS + " in a race");
    }
    List<RacePoint> points = points(request, settings);
    RaceStory story = new RaceStory(points);
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(settings)
            .robots(robots, gvh -> new RaceApp(gvh, XID, points))
            .observer(story);
    watch(simulation, points, settings);
    return new Plan(simulation, story, new RaceLayer(points), Obstacles.NONE);
  }

  /** Adds everything that is checked in a run of a race. */
  static void watch(Simulation.Builder simulation, List<RacePoint> points, SimSettings settings) {
    RaceBounds bounds =
        RaceBounds.of(
            settings.messageDelay().longestNs(),
            settings.messageLoss().probability(),
            farthestMm(points, settings));
    RaceSpec.of(points, bounds).forEach(simulation::monitor);
    RacePoint widest =
        points.stream().max(Comparator.comparingDouble(RacePoint::radiusMm)).orElseThrow();
    MotionParameters motion = Drive.motion(settings.motionParameters(0), widest);
    simulation.monitor(() -> new MotionSpec(motion));
    simulation.monitor(() -> new GeocastSpec(POSITION_ERROR_MM, Scoreboard.CLOCK_SKEW_NS));
  }

  /** From any point, or any place on the floor, to any point. */
  private static double farthestMm(List<RacePoint> points, SimSettings settings) {
    List<Point> places = new ArrayList<>();
    points.forEach(point -> places.add(point.at()));
    places.add(new Point(0, 0));
    places.add(new Point(settings.get(Setting.FLOOR_WIDTH), 0));
    places.add(new Point(0, settings.get(Setting.FLOOR_HEIGHT)));
    places.add(new Point(settings.get(Setting.FLOOR_WIDTH), settings.get(Setting.FLOOR_HEIGHT)));
    double farthestMm = 0;
    for (Point place : places) {
      for (RacePoint point : points) {
        farthestMm = Math.max(farthestMm, place.distanceMm(point.at()));
      }
    }
    return farthestMm;
  }

  private List<RacePoint> points(Request request, SimSettings settings) {
    String file = request.parameter(POINTS.key());
    if (!file.isEmpty()) {
      return RacePoints.read(file);
    }
    try {
      int count = (int) Quantities.whole(request.parameter(DRAWN.key()), 1, MOST_DRAWN);
      return RacePoints.drawn(count, settings, new Rng(request.seed()).fork(name()));
    } catch (BadInput error) {
      throw Quantities.in(DRAWN.key(), error);
    }
  }
}

package org.starl.apps.search;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.apps.Demo;
import org.starl.apps.Input;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Scenario;
import org.starl.apps.search.logic.Driving;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.apps.search.logic.SearchApp;
import org.starl.apps.search.spec.SearchSpec;
import org.starl.apps.search.view.SearchLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** The paper's Distributed Search (section 5.4): {@code starl run search}. */
public final class SearchDemo implements Demo {

  private static final String XID = "house";
  private static final String GENERATED = "generated";
  private static final String FILES_SCENARIO = "files";
  private static final String NONE = "none";
  private static final String DRAWN = "drawn";
  private static final int MAX_ROBOTS = 12;
  private static final Pattern PLACE = Pattern.compile("(-?[0-9]{1,6}),(-?[0-9]{1,6})");
  private static final double UP_RAD = StrictMath.PI / 2;

  /** "3/3 found": three runs of its own. */
  private static final String ORIGINAL = "found in 3 of 3";

  /** Of the original's sensor. */
  private static final double RANGE_MM = 600;

  private static final List<Scenario> SCENARIOS =
      List.of(
          new Scenario(GENERATED, "a house drawn from the seed; see rooms"),
          new Scenario(FILES_SCENARIO, "the original StarL's files; implied by files=FOLDER"));

  private static final Parameter SCENARIO =
      new Parameter("scenario", GENERATED, "one of the scenarios above");
  private static final Parameter ROOMS =
      new Parameter("rooms", "6", "of a generated house, 1 to " + GeneratedHouse.MAX_ROOMS);
  private static final Parameter OBJECT =
      new Parameter(
          "object",
          DRAWN,
          "what is to be found: drawn (the files' things; in a generated house a place from the"
              + " seed), none, or x,y in mm");
  private static final Parameter FILES =
      new Parameter(
          "files",
          "",
          "folder of obstacles.wpt (walls), dest.wpt (doors), start.wpt (robots) and"
              + " senseObjects.wpt (things to find)");

  @Override
  public String name() {
    return "search";
  }

  @Override
  public String summary() {
    return "robots elect a leader, it assigns rooms, they search a house (paper, section 5.4)";
  }

  @Override
  public List<Scenario> scenarios() {
    return SCENARIOS;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(SCENARIO, ROOMS, OBJECT, FILES);
  }

  @Override
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    return SimSettings.builder().duration(Duration.ofHours(4));
  }

  @Override
  public List<Input> inputs(Path data) {
    Path folder = data.resolve("starl-original").resolve("search");
    SortedMap<String, String> there = defaults();
    there.put(FILES.key(), folder.toString());
    SortedMap<String, String> empty = new TreeMap<>(there);
    empty.put(OBJECT.key(), NONE);
    return List.of(
        new Input("search", folder, there, ORIGINAL),
        new Input("search, nothing to find", folder, empty, ""));
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    Rng rng = new Rng(request.seed()).fork(name());
    SearchScene scene = scene(request, settings, rng);
    House house = scene.house();
    Obstacles walls = scene.plan().walls();
    List<ItemPosition> things = scene.things();
    SearchStory story = new SearchStory();
    TrueSensors sensors = new TrueSensors(house, things);
    Simulation.Builder simulation =
        Simulation.builder().settings(settings).obstacles(walls).director(sensors).observer(story);
    for (SearchScene.Start start : scene.robots()) {
      simulation.robot(
          new RobotSpec(
              start.robot(),
              start.pose(),
              true,
              gvh -> new SearchApp(gvh, XID, house, sensors.of(start.robot()))));
    }
    watch(simulation, house, things, settings);
    return new Plan(simulation, story, new SearchLayer(house, things), walls);
  }

  /** Adds everything that is checked in a run. */
  static void watch(
      Simulation.Builder simulation, House house, List<ItemPosition> things, SimSettings settings) {
    SearchSpec.of(house, things).forEach(simulation::monitor);
    MotionParameters motion = Driving.motion(settings.motionParameters(0));
    simulation.monitor(() -> new MotionSpec(motion));
    simulation.monitor(AgreementSpec::new);
    simulation.monitor(ElectionSpec::new);
    simulation.monitor(() -> new TubesSpec(SearchSpec.toldNs(house)));
  }

  private static SearchScene scene(Request request, SimSettings settings, Rng rng) {
    MotionParameters body = settings.motionParameters(0);
    String files = request.parameter(FILES.key());
    String scenario = request.parameter(SCENARIO.key());
    SearchScene scene;
    switch (scenario) {
      case GENERATED ->
          scene =
              files.isEmpty()
                  ? generated(request, settings, body, rng)
                  : ofFiles(files, request, body);
      case FILES_SCENARIO -> {
        if (files.isEmpty()) {
          throw new BadInput("files='': expected the folder of the house's .wpt files");
        }
        scene = ofFiles(files, request, body);
      }
      default ->
          throw new BadInput(
              "scenario=" + BadInput.quote(scenario) + ": expected generated or files");
    }
    return withObject(scene, request.parameter(OBJECT.key()));
  }

  private static SearchScene ofFiles(String files, Request request, MotionParameters body) {
    SearchScene scene = HouseFiles.read(Path.of(files), RANGE_MM, body);
    int robots = scene.robots().size();
    if (request.robots().isPresent() && request.robots().getAsInt() != robots) {
      throw new BadInput(
          "robots: " + request.robots().getAsInt() + ": expected " + robots + ", as in start.wpt");
    }
    return scene;
  }

  private static SearchScene generated(
      Request request, SimSettings settings, MotionParameters body, Rng rng) {
    int robots = request.robots().orElse(settings.robots());
    if (robots < 1 || robots > MAX_ROBOTS) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + MAX_ROBOTS);
    }
    int rooms;
    try {
      rooms = (int) Quantities.whole(request.parameter(ROOMS.key()), 1, GeneratedHouse.MAX_ROOMS);
    } catch (BadInput error) {
      throw Quantities.in(ROOMS.key(), error);
    }
    HousePlan plan = GeneratedHouse.of(rooms, robots, rng.fork("house"));
    House house = House.of(plan, RANGE_MM, Driving.clearanceMm(body, plan.bounds()));
    List<SearchScene.Start> starts = new ArrayList<>();
    for (Point start : plan.starts()) {
      RobotId robot = new RobotId(settings.robotName() + starts.size());
      starts.add(new SearchScene.Start(robot, Pose.of(start, UP_RAD)));
    }
    Point place = GeneratedHouse.somewhere(house, rng.fork("object"));
    return new SearchScene(
        house, starts, List.of(new ItemPosition("object", place.xMm(), place.yMm())));
  }

  private static SearchScene withObject(SearchScene scene, String object) {
    if (object.equals(DRAWN)) {
      return scene;
    }
    if (object.equals(NONE)) {
      return new SearchScene(scene.house(), scene.robots(), List.of());
    }
    Matcher place = PLACE.matcher(object);
    if (place.matches()) {
      Point at = new Point(Double.parseDouble(place.group(1)), Double.parseDouble(place.group(2)));
      if (scene.house().bounds().contains(at)) {
        return new SearchScene(
            scene.house(), scene.robots(), List.of(new ItemPosition("object", at.xMm(), at.yMm())));
      }
    }
    throw new BadInput(
        "object=" + BadInput.quote(object) + ": expected drawn, none or x,y on the floor, in mm");
  }
}

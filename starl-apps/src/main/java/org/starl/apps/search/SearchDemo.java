package org.starl.apps.search;

import static org.starl.apps.search.robot.SearchFactory.DRAWN;
import static org.starl.apps.search.robot.SearchFactory.FILES;
import static org.starl.apps.search.robot.SearchFactory.GENERATED;
import static org.starl.apps.search.robot.SearchFactory.NONE;
import static org.starl.apps.search.robot.SearchFactory.OBJECT;
import static org.starl.apps.search.robot.SearchFactory.SCENARIO;

import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Input;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Scenario;
import org.starl.apps.search.logic.Drive;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.robot.GeneratedHouse;
import org.starl.apps.search.robot.SearchFactory;
import org.starl.apps.search.spec.SearchSpec;
import org.starl.apps.search.view.SearchLayer;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** The paper's Distributed Search (section 5.4): {@code starl run search}. */
public final class SearchDemo implements FactoryDemo {

  private static final String FILES_SCENARIO = "files";
  private static final Pattern PLACE = Pattern.compile("(-?[0-9]{1,6}),(-?[0-9]{1,6})");
  private static final double UP_RAD = StrictMath.PI / 2;

  /** Of three runs of the original StarL. */
  private static final String ORIGINAL = "found in 3 of 3";

  private static final List<Scenario> SCENARIOS =
      List.of(
          new Scenario(GENERATED, "a house drawn from the seed; see rooms"),
          new Scenario(FILES_SCENARIO, "the original StarL's files; implied by files=FOLDER"));

  private static final SearchFactory FACTORY = new SearchFactory();

  @Override
  public AppFactory factory() {
    return FACTORY;
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
  public Envelope envelope() {
    return Envelope.MOVING;
  }

  @Override
  public Request varied(Request request) {
    return request.drawRobots(2, 8);
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
    SearchScene scene = scene(request, settings);
    House house = scene.house();
    Obstacles walls = house.plan().walls();
    SearchStory story = new SearchStory();
    Simulation.Builder simulation =
        Simulation.builder()
            .settings(settings)
            .obstacles(walls)
            .objects(house.rangeMm(), scene.things())
            .observer(story);
    scene
        .starts()
        .forEach((robot, start) ->
            simulation.robot(new RobotSpec(robot, start, true, SearchFactory.app(house))));
    watch(simulation, house, scene.things(), settings);
    return new Plan(simulation, story, new SearchLayer(house, scene.things()), walls);
  }

  /** Adds all monitors of a run. */
  static void watch(
      Simulation.Builder simulation, House house, List<ItemPosition> things, SimSettings settings) {
    boolean staysDown =
        settings.get(Setting.CHAOS) == Envelope.MORTAL
            || settings.get(Setting.FAULTS).mayLeaveDown();
    SearchSpec.of(house, things, staysDown).forEach(simulation::monitor);
    MotionParameters motion = Drive.motion(settings.motionParameters(0));
    simulation.monitor(() -> new MotionSpec(motion).inTubes());
    simulation.monitor(AgreementSpec::new);
    simulation.monitor(ElectionSpec::new);
    simulation.monitor(() -> new TubesSpec(SearchSpec.toldNs(house)));
  }

  private SearchScene scene(Request request, SimSettings settings) {
    String files = request.parameter(FILES.key());
    String scenario = request.parameter(SCENARIO.key());
    if (!scenario.equals(GENERATED) && !scenario.equals(FILES_SCENARIO)) {
      throw new BadInput("scenario=" + BadInput.quote(scenario) + ": expected generated or files");
    }
    if (scenario.equals(FILES_SCENARIO) && files.isEmpty()) {
      throw new BadInput("files='': expected the folder of the house's .wpt files");
    }
    SearchScene scene =
        files.isEmpty() ? generated(request, settings) : ofFiles(files, request, settings);
    String object = request.parameter(OBJECT.key());
    return switch (object) {
      case DRAWN -> scene;
      case NONE -> scene.withThings(List.of());
      default -> scene.withThings(List.of(objectAt(object, scene.house())));
    };
  }

  private static SearchScene ofFiles(String files, Request request, SimSettings settings) {
    SearchScene scene =
        HouseFiles.read(Path.of(files), SearchFactory.RANGE_MM, settings.motionParameters(0));
    int robots = scene.starts().size();
    if (request.robots().orElse(robots) != robots) {
      throw new BadInput(
          "robots: " + request.robots().getAsInt() + ": expected " + robots + ", as in start.wpt");
    }
    return scene;
  }

  private SearchScene generated(Request request, SimSettings settings) {
    int robots = request.robots().orElse(settings.robots());
    House house = SearchFactory.house(request, robots, settings.motionParameters(0));
    Map<RobotId, Pose> starts = new LinkedHashMap<>();
    for (Point start : house.plan().starts()) {
      starts.put(new RobotId(settings.robotName() + starts.size()), Pose.of(start, UP_RAD));
    }
    Point place = GeneratedHouse.somewhere(house, SearchFactory.rng(request).fork("object"));
    return new SearchScene(house, starts, List.of(object(place)));
  }

  private static ItemPosition objectAt(String text, House house) {
    Matcher place = PLACE.matcher(text);
    if (place.matches()) {
      Point at = new Point(Double.parseDouble(place.group(1)), Double.parseDouble(place.group(2)));
      if (house.bounds().contains(at)) {
        return object(at);
      }
    }
    throw new BadInput(
        "object=" + BadInput.quote(text) + ": expected drawn, none or x,y on the floor, in mm");
  }

  private static ItemPosition object(Point at) {
    return new ItemPosition("object", at.xMm(), at.yMm());
  }
}

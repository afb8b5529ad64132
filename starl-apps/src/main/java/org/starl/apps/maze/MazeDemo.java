package org.starl.apps.maze;

import static org.starl.apps.maze.robot.MazeFactory.CELL;
import static org.starl.apps.maze.robot.MazeFactory.COLLISION;
import static org.starl.apps.maze.robot.MazeFactory.DRAWN;
import static org.starl.apps.maze.robot.MazeFactory.FILES;
import static org.starl.apps.maze.robot.MazeFactory.MAP;
import static org.starl.apps.maze.robot.MazeFactory.SCEN;
import static org.starl.apps.maze.robot.MazeFactory.SCENARIO;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.AppFactory;
import org.starl.apps.FactoryDemo;
import org.starl.apps.Input;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.Scenario;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.apps.maze.robot.Layout;
import org.starl.apps.maze.robot.MazeFactory;
import org.starl.apps.maze.spec.MazeSpec;
import org.starl.apps.maze.view.MazeLayer;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.world.GridMap;
import org.starl.sim.world.GridMaps;
import org.starl.spec.ExceptRobots;
import org.starl.time.Time;

/** The paper's section 5.4: {@code starl run maze}. */
public final class MazeDemo implements FactoryDemo {

  private static final int MOST_BOXES = 64;
  private static final double LEAST_CELL_MM = 480;
  private static final double CELL_SPARE_MM = 20;
  private static final double MOST_CELL_MM = 10_000;

  // Bound for one robot that drives alone and bumps along every wall.
  private static final long TURN_NS = 1_800 * Time.NS_PER_S;

  private static final MazeFactory FACTORY = new MazeFactory();

  private static final List<Scenario> SCENARIOS =
      List.of(
          new Scenario(DRAWN, "a maze from the seed, some walls hidden, one cell walled in"),
          new Scenario("files", "the original StarL's files; needs files=FOLDER"),
          new Scenario("map", "a grid map of the path-finding benchmarks; needs map=FILE"));

  private static final List<String> MAPS =
      List.of(
          "empty-48-48",
          "maze-32-32-4",
          "room-32-32-4",
          "random-64-64-20",
          "den312d",
          "ht_chantry",
          "Berlin_1_256");

  @Override
  public AppFactory factory() {
    return FACTORY;
  }

  @Override
  public String summary() {
    return "robots find ways among known and hidden walls, or prove that there is none (section"
        + " 5.4)";
  }

  @Override
  public List<Scenario> scenarios() {
    return SCENARIOS;
  }

  @Override
  public Envelope envelope() {
    return Envelope.SPATIAL;
  }

  @Override
  public List<Input> inputs(Path data) {
    List<Input> inputs = new ArrayList<>();
    Path original = data.resolve("starl-original/maze");
    inputs.add(input("maze", FILES, original, "3 of 3 runs hold for ever: Path not found"));
    for (String map : MAPS) {
      inputs.add(input(map + ".map", MAP, data.resolve("maps/" + map + ".map"), ""));
    }
    inputs.removeIf(input -> !Files.exists(input.path()));
    return inputs;
  }

  private static Input input(String name, Parameter parameter, Path path, String original) {
    Map<String, String> parameters = Map.of(parameter.key(), path.toString());
    return new Input(name, path, new TreeMap<>(parameters), original);
  }

  @Override
  public Request varied(Request request) {
    return request
        .drawRobots(2, 8)
        .drawParameter(COLLISION, request.seed() % 2 == 0 ? "discover" : "stop");
  }

  @Override
  public SimSettings.Builder defaultSettings(Request request) {
    int robots = robots(request);
    return SimSettings.builder()
        .set(Setting.ROBOTS, robots)
        .set(Setting.DURATION.key(), (robots + 1) * (TURN_NS / Time.NS_PER_S) + "s");
  }

  private static int robots(Request request) {
    int usual =
        switch (scenario(request)) {
          case "files" -> 1;
          case "map" -> 6;
          default -> 4;
        };
    return request.robots().orElse(usual);
  }

  @Override
  public Plan plan(Request request, SimSettings settings) {
    int robots = request.robots().orElse(settings.robots());
    MazeFactory.checkRobots(robots);
    Layout layout = layout(request, settings, robots);
    CollisionMode mode = MazeFactory.mode(request);
    RobotProgram program = MazeFactory.program(layout, mode);
    Obstacles obstacles = layout.obstacles();
    double bodyMm = settings.robotRadiusMm();
    Simulation.Builder simulation = Simulation.builder().settings(settings).obstacles(obstacles);
    SortedMap<RobotId, MazeTask> tasks = new TreeMap<>();
    int goals = 0;
    for (int i = 0; i < robots; i++) {
      RobotId id = new RobotId(settings.robotName() + i);
      Pose start = layout.robots().get(i).start();
      MazeTask task = layout.task(i, bodyMm, mode);
      tasks.put(id, task);
      goals += task.goals().size();
      simulation.robot(new RobotSpec(id, start, true, program.app()));
    }
    MazeStory story = new MazeStory(goals);
    simulation
        .observer(story)
        .monitor(() ->
            new ExceptRobots(
                new MazeSpec(obstacles, tasks, bodyMm, robots * TURN_NS),
                settings.strayRobots(List.copyOf(tasks.keySet())),
                List.of(MazeSpec.APART, MazeSpec.HELD),
                "leave their way"));
    program.monitors().forEach(simulation::monitor);
    return new Plan(simulation, story, new MazeLayer(tasks), obstacles);
  }

  private static String scenario(Request request) {
    String scenario = request.parameter(SCENARIO.key());
    boolean hasFiles = !request.parameter(FILES.key()).isEmpty();
    boolean hasMap = !request.parameter(MAP.key()).isEmpty();
    if (hasFiles && hasMap) {
      throw new BadInput("files and map are both set: expected only one of them");
    }
    if (!hasMap && !request.parameter(SCEN.key()).isEmpty()) {
      throw new BadInput("scen is set without map: expected map=FILE, the map of its places");
    }
    String implied = hasFiles ? "files" : hasMap ? "map" : SCENARIO.defaultValue();
    if (!scenario.equals(implied) && !scenario.equals(SCENARIO.defaultValue())) {
      String hint = NearMatches.hint(scenario, List.of(DRAWN, "files", "map"));
      throw bad(SCENARIO, scenario, "drawn, files with files=FOLDER, or map with map=FILE" + hint);
    }
    return implied;
  }

  private static Layout layout(Request request, SimSettings settings, int robots) {
    Rng rng = MazeFactory.rng(request);
    double bodyMm = settings.robotRadiusMm();
    return switch (scenario(request)) {
      case "files" -> {
        double widthMm = settings.get(Setting.FLOOR_WIDTH);
        Rectangle floor = new Rectangle(0, 0, widthMm, settings.get(Setting.FLOOR_HEIGHT));
        Path folder = Path.of(request.parameter(FILES.key()));
        yield FileMaze.read(folder, floor, robots, bodyMm, rng.fork("files"));
      }
      case "map" -> {
        GridMap map = GridMaps.read(Path.of(request.parameter(MAP.key())));
        int boxes =
            MazeFactory.hidden(
                request, robots, text -> (int) Quantities.whole(text, 0, MOST_BOXES));
        String scen = request.parameter(SCEN.key());
        Path list = scen.isEmpty() ? null : Path.of(scen);
        yield MapMaze.of(map, list, cellMm(request, bodyMm), robots, boxes, rng);
      }
      default -> MazeFactory.drawn(request, robots);
    };
  }

  private static double cellMm(Request request, double bodyMm) {
    double cellMm = request.amount(CELL);
    double leastMm = Math.max(LEAST_CELL_MM, 2 * (bodyMm + MazeTask.MARGIN_MM)) + CELL_SPARE_MM;
    if (cellMm < leastMm || cellMm > MOST_CELL_MM) {
      String least = Math.round(leastMm) + "mm (room for a body and its margin)";
      throw bad(CELL, request.parameter(CELL.key()), least + " to 10m");
    }
    return cellMm;
  }

  private static BadInput bad(Parameter parameter, String text, String expected) {
    return new BadInput(parameter.key() + "=" + BadInput.quote(text) + ": expected " + expected);
  }
}

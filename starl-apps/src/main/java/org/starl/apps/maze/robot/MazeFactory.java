package org.starl.apps.maze.robot;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.starl.apps.AppFactory;
import org.starl.apps.Parameter;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.MazeApp;
import org.starl.apps.maze.logic.MazeFact;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.input.Quantities;
import org.starl.input.Quantity;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.random.Rng;
import org.starl.trace.Vocabulary;

/** The paper's maze, drawn from the seed. */
public final class MazeFactory implements AppFactory {

  public static final String DRAWN = "drawn";

  public static final Parameter SCENARIO =
      new Parameter("scenario", DRAWN, "one of the scenarios above");
  public static final Parameter FILES =
      new Parameter(
          "files",
          "",
          "folder of dest.wpt, obstacles.wpt and maybe start.wpt; implies scenario=files");
  public static final Parameter MAP =
      new Parameter("map", "", "a grid map (.map); implies scenario=map");
  public static final Parameter SCEN =
      new Parameter(
          "scen",
          "",
          "starts and goals on the map, one line for each robot (.scen); default: drawn");
  public static final Parameter CELL =
      new Parameter(
          "cell",
          "500mm",
          "side of a cell of the map",
          Form.between(Quantity.DISTANCE, "500mm", "10m"));
  public static final Parameter HIDDEN =
      new Parameter(
          "hidden",
          "",
          "drawn: part of the walls that is hidden, 0 to 1 (default: 0.4); map: number of hidden"
              + " boxes on the robots' shortest ways, 0 to 64 (default: one per robot)");
  public static final Parameter COLLISION =
      new Parameter(
          "collision",
          "back",
          "what a robot does after a bump",
          Form.choice(
              Arrays.stream(CollisionMode.values())
                  .map(mode -> mode.name().toLowerCase(Locale.ROOT))
                  .collect(Collectors.toList())));

  private static final int MOST_ROBOTS = 32;
  private static final double HIDDEN_PART = 0.4;

  @Override
  public String name() {
    return "maze";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(SCENARIO, FILES, MAP, SCEN, CELL, HIDDEN, COLLISION);
  }

  @Override
  public Vocabulary vocabulary(Request request) {
    return MazeFact.VOCABULARY;
  }

  @Override
  public RobotProgram program(Request request) {
    for (Parameter parameter : Arrays.asList(SCENARIO, FILES, MAP, SCEN, CELL)) {
      request.refuseOnRobots(parameter);
    }
    int robots = request.robots().orElse(1);
    checkRobots(robots);
    return program(drawn(request, robots), mode(request));
  }

  /** The program of the robots of this maze. */
  public static RobotProgram program(Layout maze, CollisionMode mode) {
    return RobotProgram.of(
            gvh -> {
              double bodyMm = gvh.plat.moat.parameters().robotRadiusMm();
              return new MazeApp(gvh, maze.task(RobotProgram.number(gvh), bodyMm, mode));
            })
        .withMap(maze.obstacles().known())
        .withMonitor(MutexSpec::new);
  }

  /**
   * @throws BadInput if a maze has not room for so many robots
   */
  public static void checkRobots(int robots) {
    if (robots < 1 || robots > MOST_ROBOTS) {
      throw new BadInput("robots: " + robots + ": expected 1 to " + MOST_ROBOTS + " in a maze");
    }
  }

  /** The maze that a request draws. */
  public static Layout drawn(Request request, int robots) {
    return DrawnMaze.draw(
        robots, hidden(request, HIDDEN_PART, Quantities::probability), rng(request));
  }

  /** The generator of a request's maze. */
  public static Rng rng(Request request) {
    return new Rng(request.seed()).fork("maze");
  }

  /** The value of {@link #HIDDEN}. */
  public static <T> T hidden(Request request, T usual, Function<String, T> parser) {
    return request.parse(HIDDEN, text -> text.isEmpty() ? usual : parser.apply(text));
  }

  /**
   * The value of {@link #COLLISION}.
   *
   * @throws BadInput if it is no mode
   */
  public static CollisionMode mode(Request request) {
    return CollisionMode.valueOf(request.choice(COLLISION).toUpperCase(Locale.ROOT));
  }
}

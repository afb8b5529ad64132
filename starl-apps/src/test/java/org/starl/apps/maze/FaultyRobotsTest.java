package org.starl.apps.maze;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.maze.logic.Answer;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.MazeFact;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.apps.maze.robot.DrawnMaze;
import org.starl.apps.maze.robot.Layout;
import org.starl.apps.maze.spec.MazeSpec;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;
import org.starl.trace.Instance;

/** Simulates faulty robots: the specification must report each planted bug. */
class FaultyRobotsTest {

  private static final int SEEDS = 20;
  private static final double BODY_MM = 165;
  private static final long BOUND_NS = 300 * Time.NS_PER_S;

  enum Bug {
    /** Treats a bump as an arrival, as the original's motion did. */
    BUMPED_IS_THERE,
    /** Answers that there is no way at the first bump, as the original did when its planner failed. */
    BUMPED_IS_NO_WAY,
    /** Marks a square around a guessed point of contact, widened by the body. */
    MARKS_A_GUESS,
    /** Requests no blocks, and drives to where another robot stands. */
    REQUESTS_NO_BLOCKS,
    /** Waits for ever after a bump, without an answer. */
    HOLDS_FOR_EVER
  }

  private static final class FaultyRobot extends LogicThread {
    private final MazeTask task;
    private final Bug bug;

    FaultyRobot(GlobalVarHolder gvh, MazeTask task, Bug bug) {
      super(gvh);
      this.task = task;
      this.bug = bug;
      gvh.plat.moat.onContact(contact -> {
        if (bug == Bug.MARKS_A_GUESS) {
          Point at = contact.at().pose().at();
          double headingRad = contact.at().pose().headingRad();
          double x = at.xMm() + BODY_MM * StrictMath.cos(headingRad);
          double y = at.yMm() + BODY_MM * StrictMath.sin(headingRad);
          double mm = BODY_MM + 75;
          Polygon square =
              Polygon.of(
                  new Point(x - mm, y - mm),
                  new Point(x + mm, y - mm),
                  new Point(x + mm, y + mm),
                  new Point(x - mm, y + mm));
          gvh.trace.action(Instance.APP, MazeFact.SHAPE, new MazeFact.Marked(square));
        }
      });
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      var goal = task.goals().get(0);
      Point to = bug == Bug.REQUESTS_NO_BLOCKS ? task.others().get(0).axis().from() : goal.at();
      gvh.plat.moat.doMove(new ItemPosition(goal.name(), to.xMm(), to.yMm()));
      await(() -> !gvh.plat.moat.inMotion());
      boolean isThere = !gvh.plat.moat.failed();
      switch (bug) {
        case BUMPED_IS_THERE -> answer(Answer.REACHED);
        case BUMPED_IS_NO_WAY -> answer(isThere ? Answer.REACHED : Answer.NO_WAY);
        case HOLDS_FOR_EVER -> {
          await(() -> isThere);
          answer(Answer.REACHED);
        }
        case MARKS_A_GUESS, REQUESTS_NO_BLOCKS -> answer(Answer.GAVE_UP);
      }
      return List.of();
    }

    private void answer(Answer answer) {
      String name = task.goals().get(0).name();
      double errorMm = gvh.gps.errorMm() + 75;
      gvh.trace.action(Instance.APP, MazeFact.SHAPE, new MazeFact.Answered(name, answer, errorMm));
    }
  }

  private static SimResult run(Bug bug, long seed) {
    Layout walled = DrawnMaze.draw(4, 0.5, new Rng(seed).fork("maze"));
    Obstacles obstacles = bug == Bug.REQUESTS_NO_BLOCKS ? Obstacles.NONE : walled.obstacles();
    Layout layout = new Layout(walled.floor(), obstacles, walled.robots());
    SortedMap<RobotId, MazeTask> tasks = new TreeMap<>();
    SimSettings settings = SimSettings.builder().set("duration", "400s").build();
    Simulation.Builder simulation =
        Simulation.builder().seed(seed).settings(settings).obstacles(layout.obstacles());
    for (int i = 0; i < layout.robots().size(); i++) {
      RobotId id = new RobotId("bot" + i);
      MazeTask task = layout.task(i, BODY_MM, CollisionMode.STOP);
      tasks.put(id, task);
      simulation.robot(
          new RobotSpec(
              id, layout.robots().get(i).start(), true, gvh -> new FaultyRobot(gvh, task, bug)));
    }
    return simulation
        .monitor(() -> new MazeSpec(layout.obstacles(), tasks, BODY_MM, BOUND_NS))
        .build()
        .run();
  }

  @ParameterizedTest
  @CsvSource({
    "BUMPED_IS_THERE, maze.Reached",
    "BUMPED_IS_NO_WAY, maze.NoWay",
    "MARKS_A_GUESS, maze.Belief",
    "MARKS_A_GUESS, maze.Told",
    "REQUESTS_NO_BLOCKS, maze.Apart",
    "REQUESTS_NO_BLOCKS, maze.held",
    "HOLDS_FOR_EVER, maze.Answered",
  })
  void aPlantedBugViolatesItsLemma(Bug bug, String lemma) {
    long seed = 0;
    SimResult result;
    do {
      seed++;
      result = run(bug, seed);
    } while (result.spec().violations(lemma) == 0 && seed < SEEDS);
    assertThat(result.spec().violations(lemma)).as("%s, seeds 1..%d", bug, SEEDS).isPositive();
  }
}

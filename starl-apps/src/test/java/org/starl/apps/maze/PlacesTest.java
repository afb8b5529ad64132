package org.starl.apps.maze;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;
import org.starl.random.Rng;

/** Drawn places against the planner that robots use. */
class PlacesTest {

  private static boolean leads(Layout layout, int i, boolean pastTheOthers) {
    Layout.Robot robot = layout.robots().get(i);
    PlanTask task =
        new PlanTask(
            robot.start().at(),
            robot.goals().get(0).at(),
            layout.floor(),
            layout.obstacles(),
            pastTheOthers ? layout.others(i, 165) : List.of(),
            165,
            75);
    return new LocalPlanner().plan(task) instanceof Plan.Found;
  }

  /** The first maze that this seed draws has no room for four. */
  @Test
  void aMazeWithoutRoomIsDrawnAgain() {
    assertThat(DrawnMaze.draw(4, 0.5, new Rng(58)).robots()).hasSize(4);
  }

  @Property(tries = 25)
  void noRobotOfADrawnMazeBlocksAnothersOnlyWay(@ForAll long seed) {
    Layout layout = DrawnMaze.draw(4, 0.5, new Rng(seed));
    assertThat(layout.robots()).hasSize(4);
    for (int i = 0; i < 4; i++) {
      assertThat(leads(layout, i, true)).as("robot %d", i).isEqualTo(leads(layout, i, false));
    }
  }

  @Property(tries = 10)
  void placesAreDistinctOnABoardWithBoxes(@ForAll long seed) {
    Board board = new Board(9, 7, 500);
    Rng rng = new Rng(seed);
    for (int i = 0; i < 12; i++) {
      board.setFree(rng.nextInt(board.cells()), false);
    }
    Places places = new Places(board, 3, 30, rng);
    places.draw(3);
    places.hideBoxes(3);
    TreeSet<Double> corners = new TreeSet<>();
    for (Layout.Robot robot : places.robots()) {
      corners.add(robot.start().xMm() * 1e6 + robot.start().yMm());
      Point goal = robot.goals().get(0).at();
      corners.add(goal.xMm() * 1e6 + goal.yMm());
    }
    assertThat(corners).as("no place is used twice").hasSize(6);
  }

  @Property(tries = 50)
  void aWayIsAsLongAsItsSteps(@ForAll long seed) {
    Board board = new Board(8, 8, 500);
    Rng rng = new Rng(seed);
    for (int i = 0; i < 20; i++) {
      board.setFree(rng.nextInt(64), false);
      int cell = rng.nextInt(64);
      board.setWall(cell, board.neighbours(cell).get(0), true);
    }
    int from = rng.nextInt(64);
    int to = rng.nextInt(64);
    board.setFree(from, true);
    board.setFree(to, true);
    List<Integer> way = board.way(from, to, new BitSet());
    int steps = board.steps(from, new BitSet())[to];
    assertThat(way).hasSize(steps + 1);
    for (int i = 1; i < way.size(); i++) {
      assertThat(board.neighbours(way.get(i))).contains(way.get(i - 1));
      assertThat(board.hasWall(way.get(i), way.get(i - 1))).isFalse();
      assertThat(board.isFree(way.get(i))).isTrue();
    }
  }
}

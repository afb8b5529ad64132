package org.starl.apps.maze.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.geometry.Point;
import org.starl.primitives.paths.Capsule;
import org.starl.random.Rng;

/** Drawn places against the planner that robots use. */
class PlacesTest {

  private static boolean hasWay(Layout layout, int i, boolean pastTheOthers) {
    MazeTask task = layout.task(i, 165, CollisionMode.STOP);
    List<Capsule> others = pastTheOthers ? task.others() : List.of();
    return task.hasWay(task.goals().get(0), layout.obstacles(), others, 165);
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
      assertThat(hasWay(layout, i, true)).as("robot %d", i).isEqualTo(hasWay(layout, i, false));
    }
  }

  @Property(tries = 10)
  void placesAreDistinctOnABoardWithBoxes(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Board board = Board.open(9, 7, 500, cell -> rng.nextBoolean(0.8));
    Places places = new Places(board, 3, rng);
    places.draw(3);
    List<Integer> boxes = places.hideBoxes(3);
    assertThat(boxes).doesNotHaveDuplicates().allMatch(board.free()::get);
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
    Rng rng = new Rng(seed);
    int from = rng.nextInt(64);
    int to = rng.nextInt(64);
    Board board = Board.open(8, 8, 500, cell -> cell == from || cell == to || rng.nextBoolean(0.7));
    for (int i = 0; i < 20; i++) {
      int cell = rng.nextInt(64);
      board.setLinked(cell, board.neighbours(cell).get(0), false);
    }
    List<Integer> way = board.way(from, to, new BitSet());
    int steps = board.steps(from, new BitSet(), -1)[to];
    assertThat(way).hasSize(steps + 1);
    for (int i = 1; i < way.size(); i++) {
      assertThat(board.neighbours(way.get(i))).contains(way.get(i - 1));
      assertThat(board.isLinked(way.get(i), way.get(i - 1))).isTrue();
      assertThat(board.free().get(way.get(i))).isTrue();
    }
  }
}

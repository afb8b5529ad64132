package org.starl.apps.maze;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.starl.apps.maze.logic.Goal;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/**
 * Draws starts and goals in the middle of cells: three of four goals within reach, the others cut
 * off, if the board has such places. Whoever can reach its goal at all can do so past the starts and
 * goals of all others.
 */
final class Places {

  private static final double TOLERANCE_MM = 20;
  private static final double CUT_OFF = 0.25;
  private static final int TRIES = 3_000;
  private static final int TRIES_FOR_CUT_OFF = 40;
  private static final int TRIES_FOR_A_BOX = 20;

  private final Board board;
  private final int fewestSteps;
  private final int mostSteps;
  private final Rng rng;
  private final List<int[]> pairs = new ArrayList<>();

  /** Goals that were to be cut off, and are not. */
  private final List<Integer> toClose = new ArrayList<>();

  /**
   * @param mostSteps a goal in reach is so many cells off at most, where nothing hidden is in the way
   */
  Places(Board board, int fewestSteps, int mostSteps, Rng rng) {
    this.board = board;
    this.fewestSteps = fewestSteps;
    this.mostSteps = mostSteps;
    this.rng = rng;
  }

  /**
   * @return how many found room: {@code robots}, or fewer
   */
  int draw(int robots) {
    while (pairs.size() < robots && drawOne()) {
      // The next one.
    }
    return pairs.size();
  }

  static BadInput noRoom(int robots, int found) {
    return new BadInput("robots: " + robots + ": no room for more than " + found + " of them here");
  }

  private boolean drawOne() {
    boolean isCutOff = rng.nextBoolean(CUT_OFF);
    for (int i = 0; i < TRIES; i++) {
      int start = freeCell();
      int goal = start < 0 ? -1 : goal(start, isCutOff && i < TRIES_FOR_CUT_OFF);
      if (goal >= 0) {
        pairs.add(new int[] {start, goal});
        if (nobodyIsInTheWay()) {
          if (isCutOff && i >= TRIES_FOR_CUT_OFF) {
            toClose.add(goal);
          }
          return true;
        }
        pairs.remove(pairs.size() - 1);
      }
    }
    return false;
  }

  private int freeCell() {
    int cell = rng.nextInt(board.cells());
    return board.isFree(cell) && !used(-1).get(cell) ? cell : -1;
  }

  private int goal(int start, boolean isCutOff) {
    int[] steps = board.steps(start, new BitSet());
    BitSet used = used(-1);
    List<Integer> choice = new ArrayList<>();
    for (int cell = 0; cell < board.cells(); cell++) {
      boolean fits =
          isCutOff
              ? steps[cell] < 0 && isNear(start, cell)
              : steps[cell] >= fewestSteps && steps[cell] <= mostSteps;
      if (fits && cell != start && board.isFree(cell) && !used.get(cell)) {
        choice.add(cell);
      }
    }
    return choice.isEmpty() ? -1 : choice.get(rng.nextInt(choice.size()));
  }

  private boolean isNear(int a, int b) {
    return board.middle(a).distanceMm(board.middle(b)) <= mostSteps * board.cellMm() / 2;
  }

  /** The starts and goals of all but one. */
  private BitSet used(int except) {
    BitSet used = new BitSet();
    for (int i = 0; i < pairs.size(); i++) {
      if (i != except) {
        used.set(pairs.get(i)[0]);
        used.set(pairs.get(i)[1]);
      }
    }
    return used;
  }

  private boolean nobodyIsInTheWay() {
    for (int i = 0; i < pairs.size(); i++) {
      int start = pairs.get(i)[0];
      int goal = pairs.get(i)[1];
      if (board.steps(start, used(i))[goal] < 0 && board.steps(start, new BitSet())[goal] >= 0) {
        return false;
      }
    }
    return true;
  }

  /**
   * Blocks cells on the robots' shortest ways, in turn, which nobody is told of: some goals are cut
   * off by that. So are those that were to be: by boxes all round.
   */
  List<Integer> hideBoxes(int count) {
    List<Integer> boxes = new ArrayList<>();
    if (count > 0) {
      toClose.forEach(goal -> boxes.addAll(close(goal)));
    }
    for (int i = 0; i < count; i++) {
      int box = hideBox(i % pairs.size());
      if (box >= 0) {
        boxes.add(box);
      }
    }
    return boxes;
  }

  private List<Integer> close(int goal) {
    List<Integer> around = board.neighbours(goal);
    BitSet ends = used(-1);
    around.removeIf(cell -> !board.isFree(cell));
    around.forEach(cell -> board.setFree(cell, false));
    if (around.stream().anyMatch(ends::get) || !nobodyIsInTheWay()) {
      around.forEach(cell -> board.setFree(cell, true));
      around.clear();
    }
    return around;
  }

  private int hideBox(int index) {
    List<Integer> way = board.way(pairs.get(index)[0], pairs.get(index)[1], used(index));
    BitSet ends = used(-1);
    for (int i = 0; way.size() > 2 && i < TRIES_FOR_A_BOX; i++) {
      int cell = way.get(1 + rng.nextInt(way.size() - 2));
      if (!ends.get(cell)) {
        board.setFree(cell, false);
        if (nobodyIsInTheWay()) {
          return cell;
        }
        board.setFree(cell, true);
      }
    }
    return -1;
  }

  List<Layout.Robot> robots() {
    List<Layout.Robot> robots = new ArrayList<>();
    for (int[] pair : pairs) {
      var at = board.middle(pair[0]);
      double headingRad = StrictMath.PI * (2 * rng.nextDouble() - 1);
      Goal goal = new Goal("G" + robots.size(), board.middle(pair[1]), TOLERANCE_MM);
      robots.add(new Layout.Robot(new Pose(at.xMm(), at.yMm(), headingRad), List.of(goal)));
    }
    return robots;
  }
}

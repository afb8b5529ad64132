package org.starl.apps.maze;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.starl.apps.maze.logic.Goal;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/**
 * Draws a start and a goal for each robot, in the middle of cells. About three of four goals can be
 * reached; the others are cut off, if the board has such places. A goal that can be reached can be
 * reached past the starts and goals of all other robots.
 */
final class Places {

  private static final double TOLERANCE_MM = 20;
  private static final double CUT_OFF = 0.25;
  private static final int TRIES = 3_000;
  private static final int TRIES_FOR_CUT_OFF = 40;
  private static final int TRIES_FOR_A_BOX = 20;
  private static final int NONE = -1;

  private final Board board;
  private final int fewestSteps;
  private final int mostSteps;
  private final Rng rng;
  private final List<Pair> pairs = new ArrayList<>();

  // Goals that were to be cut off and are not, for want of such places.
  private final List<Integer> toClose = new ArrayList<>();

  /** The cells of one robot. */
  private record Pair(int start, int goal) {}

  /**
   * @param mostSteps to a goal that can be reached, without boxes on the way
   */
  Places(Board board, int fewestSteps, int mostSteps, Rng rng) {
    this.board = board;
    this.fewestSteps = fewestSteps;
    this.mostSteps = mostSteps;
    this.rng = rng;
  }

  /**
   * Draws the places of {@code robots} robots.
   *
   * @return the number of robots that found room
   */
  int draw(int robots) {
    boolean hasRoom = true;
    while (hasRoom && pairs.size() < robots) {
      hasRoom = drawOne();
    }
    return pairs.size();
  }

  static BadInput noRoom(int robots, int found) {
    return new BadInput("robots: " + robots + ": no room for more than " + found + " of them here");
  }

  private boolean drawOne() {
    boolean isCutOff = rng.nextBoolean(CUT_OFF);
    for (int i = 0; i < TRIES; i++) {
      int start = rng.nextInt(board.cells());
      boolean isFree = board.isFree(start) && !used(NONE).get(start);
      int goal = isFree ? goal(start, isCutOff && i < TRIES_FOR_CUT_OFF) : NONE;
      if (goal != NONE) {
        pairs.add(new Pair(start, goal));
        if (isFreeOfBlocking()) {
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

  private int goal(int start, boolean isCutOff) {
    int[] steps = board.steps(start, new BitSet());
    BitSet used = used(NONE);
    List<Integer> choice =
        IntStream.range(0, board.cells())
            .filter(cell -> cell != start && board.isFree(cell) && !used.get(cell))
            .filter(cell ->
                isCutOff
                    ? steps[cell] < 0 && isNear(start, cell)
                    : steps[cell] >= fewestSteps && steps[cell] <= mostSteps)
            .boxed()
            .toList();
    return choice.isEmpty() ? NONE : choice.get(rng.nextInt(choice.size()));
  }

  private boolean isNear(int a, int b) {
    return board.middle(a).distanceMm(board.middle(b)) <= mostSteps * board.cellMm() / 2;
  }

  /** The starts and goals of all robots but one. */
  private BitSet used(int except) {
    BitSet used = new BitSet();
    for (int i = 0; i < pairs.size(); i++) {
      if (i != except) {
        used.set(pairs.get(i).start());
        used.set(pairs.get(i).goal());
      }
    }
    return used;
  }

  /** Whether every goal that can be reached can be reached past the other robots' places. */
  private boolean isFreeOfBlocking() {
    for (int i = 0; i < pairs.size(); i++) {
      int start = pairs.get(i).start();
      int goal = pairs.get(i).goal();
      if (board.steps(start, used(i))[goal] < 0 && board.steps(start, new BitSet())[goal] >= 0) {
        return false;
      }
    }
    return true;
  }

  /**
   * Blocks {@code count} cells on the robots' shortest ways, in turn, fewer if there is no room. This
   * cuts off some goals. If {@code count} is above 0, also blocks the cells around the goals that were
   * to be cut off.
   *
   * @return the cells
   */
  List<Integer> hideBoxes(int count) {
    List<Integer> boxes = new ArrayList<>();
    if (count > 0) {
      toClose.forEach(goal -> boxes.addAll(close(goal)));
    }
    for (int i = 0; i < count && !pairs.isEmpty(); i++) {
      int box = hideBox(i % pairs.size());
      if (box != NONE) {
        boxes.add(box);
      }
    }
    return boxes;
  }

  private List<Integer> close(int goal) {
    List<Integer> around = board.neighbours(goal).stream().filter(board::isFree).toList();
    around.forEach(cell -> board.setFree(cell, false));
    if (around.stream().anyMatch(used(NONE)::get) || !isFreeOfBlocking()) {
      around.forEach(cell -> board.setFree(cell, true));
      return List.of();
    }
    return around;
  }

  private int hideBox(int index) {
    List<Integer> way = board.way(pairs.get(index).start(), pairs.get(index).goal(), used(index));
    BitSet used = used(NONE);
    for (int i = 0; way.size() > 2 && i < TRIES_FOR_A_BOX; i++) {
      int cell = way.get(1 + rng.nextInt(way.size() - 2));
      if (!used.get(cell)) {
        board.setFree(cell, false);
        if (isFreeOfBlocking()) {
          return cell;
        }
        board.setFree(cell, true);
      }
    }
    return NONE;
  }

  List<Layout.Robot> robots() {
    List<Layout.Robot> robots = new ArrayList<>();
    for (Pair pair : pairs) {
      Point at = board.middle(pair.start());
      double headingRad = StrictMath.PI * (2 * rng.nextDouble() - 1);
      Goal goal = new Goal("G" + robots.size(), board.middle(pair.goal()), TOLERANCE_MM);
      robots.add(new Layout.Robot(new Pose(at.xMm(), at.yMm(), headingRad), List.of(goal)));
    }
    return robots;
  }
}

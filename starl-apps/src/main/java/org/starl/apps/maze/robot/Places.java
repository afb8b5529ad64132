package org.starl.apps.maze.robot;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
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
public final class Places {

  private static final int MOST_STEPS = 60;
  private static final double TOLERANCE_MM = 20;
  private static final double CUT_OFF = 0.25;
  private static final int TRIES = 3_000;
  private static final int TRIES_FOR_CUT_OFF = 40;
  private static final int TRIES_FOR_A_BOX = 20;

  private final Board board;
  private final int fewestSteps;
  private final Rng rng;
  private final List<Pair> pairs = new ArrayList<>();

  // Cells with a hidden box.
  private final BitSet boxes = new BitSet();

  // Goals that were to be cut off, but no such place was found.
  private final List<Integer> toClose = new ArrayList<>();

  /** The cells of one robot. */
  private record Pair(int start, int goal) {}

  /**
   * @param fewestSteps to a goal that can be reached
   */
  public Places(Board board, int fewestSteps, Rng rng) {
    this.board = board;
    this.fewestSteps = fewestSteps;
    this.rng = rng;
  }

  /**
   * Draws the places of {@code robots} robots.
   *
   * @return the number of robots that found room
   */
  public int draw(int robots) {
    while (pairs.size() < robots && drawOne()) {}
    return pairs.size();
  }

  /** Adds a robot; false if its cells are another's, or if it and another block each other's way. */
  public boolean add(int start, int goal) {
    BitSet occupied = occupied(null);
    pairs.add(new Pair(start, goal));
    return !occupied.get(start) && !occupied.get(goal) && isFreeOfBlocking();
  }

  /** @param fewestSteps to a robot's goal; 0 if there is none */
  public static BadInput noRoom(int robots, int found, int fewestSteps) {
    String room = "room for " + found + " in this maze";
    String away = fewestSteps + " to " + MOST_STEPS + " cells away";
    return new BadInput(
        ("robots: " + robots + ": found " + room + "; expected fewer robots or a larger maze")
            + (fewestSteps == 0 ? "" : ": each robot has a goal " + away));
  }

  private boolean drawOne() {
    boolean isCutOff = rng.nextBoolean(CUT_OFF);
    for (int i = 0; i < TRIES; i++) {
      int start = rng.nextInt(board.cells());
      List<Integer> goals = goals(start, isCutOff && i < TRIES_FOR_CUT_OFF);
      if (!goals.isEmpty()) {
        pairs.add(new Pair(start, goals.get(rng.nextInt(goals.size()))));
        if (isFreeOfBlocking()) {
          if (isCutOff && i >= TRIES_FOR_CUT_OFF) {
            toClose.add(pairs.get(pairs.size() - 1).goal());
          }
          return true;
        }
        pairs.remove(pairs.size() - 1);
      }
    }
    return false;
  }

  /** The cells from which to choose the goal of a robot that starts at {@code start}. */
  private List<Integer> goals(int start, boolean isCutOff) {
    BitSet open = (BitSet) board.free().clone();
    open.andNot(occupied(null));
    if (!open.get(start)) {
      return List.of();
    }
    int[] steps = board.steps(start, boxes, -1);
    double nearMm = MOST_STEPS * board.cellMm() / 2;
    return open.stream()
        .filter(cell ->
            isCutOff
                ? steps[cell] < 0 && board.middle(start).distanceMm(board.middle(cell)) <= nearMm
                : steps[cell] >= fewestSteps && steps[cell] <= MOST_STEPS)
        .boxed()
        .collect(Collectors.toList());
  }

  /** The boxes, and the starts and goals of all robots but one. */
  private BitSet occupied(@Nullable Pair except) {
    BitSet occupied = (BitSet) boxes.clone();
    for (Pair pair : pairs) {
      if (!pair.equals(except)) {
        occupied.set(pair.start());
        occupied.set(pair.goal());
      }
    }
    return occupied;
  }

  /** Whether every goal that can be reached can be reached past the other robots' places. */
  private boolean isFreeOfBlocking() {
    return pairs.stream().allMatch(pair -> hasWay(pair, occupied(pair)) || !hasWay(pair, boxes));
  }

  private boolean hasWay(Pair pair, BitSet avoided) {
    return board.steps(pair.start(), avoided, pair.goal())[pair.goal()] >= 0;
  }

  /**
   * Blocks {@code count} cells on the robots' shortest ways, in turn, fewer if there is no room.
   * This cuts off some goals. If {@code count} is above 0, also blocks the cells around the goals
   * that were to be cut off.
   *
   * @return the cells
   */
  public List<Integer> hideBoxes(int count) {
    if (count > 0) {
      toClose.forEach(goal ->
          tryToHide(
              board.neighbours(goal).stream()
                  .filter(cell -> board.isLinked(goal, cell))
                  .collect(Collectors.toList())));
    }
    for (int i = 0; i < count; i++) {
      hideBox(pairs.get(i % pairs.size()));
    }
    return boxes.stream().boxed().collect(Collectors.toList());
  }

  private void hideBox(Pair pair) {
    List<Integer> way = board.way(pair.start(), pair.goal(), occupied(pair));
    boolean isHidden = false;
    for (int i = 0; way.size() > 2 && !isHidden && i < TRIES_FOR_A_BOX; i++) {
      isHidden = tryToHide(List.of(way.get(1 + rng.nextInt(way.size() - 2))));
    }
  }

  /** Puts boxes on cells, unless one is a robot's place, or robots would block each other's way. */
  private boolean tryToHide(List<Integer> cells) {
    BitSet before = (BitSet) boxes.clone();
    boolean isPlace =
        pairs.stream().anyMatch(p -> cells.contains(p.start()) || cells.contains(p.goal()));
    cells.forEach(boxes::set);
    if (isPlace || !isFreeOfBlocking()) {
      boxes.and(before);
      return false;
    }
    return true;
  }

  public List<Layout.Robot> robots() {
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

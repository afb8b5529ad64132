package org.starl.apps.maze.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;

/**
 * One robot's goals in turn, the answers so far, and whether the robot drives back to its resting
 * place: its start, or the last goal that it reached. Pure.
 */
final class Agenda {

  private static final double BACK_MM = 20;

  private final ArrayDeque<Goal> goals;
  private final List<Object> answers = new ArrayList<>();
  private Point rest;
  private boolean goesBack;
  private boolean needsAll;
  private boolean isCutOff;

  Agenda(MazeTask task) {
    goals = new ArrayDeque<>(task.goals());
    rest = task.start();
  }

  /** Whether all goals are answered. */
  boolean isDone() {
    return goals.isEmpty();
  }

  /** The first goal without an answer; there must be one. */
  Goal goal() {
    return goals.element();
  }

  /** Whether the robot drives back, not to its goal. */
  boolean goesBack() {
    return goesBack;
  }

  /** The destination. */
  Point to() {
    return goesBack ? rest : goal().at();
  }

  /** The robot has arrived when it is nearer than this. */
  double toleranceMm() {
    return goesBack ? BACK_MM : goal().toleranceMm();
  }

  /** Whether the robot has to hold all blocks of the floor for this goal. */
  boolean needsAll() {
    return needsAll;
  }

  /** There is a way, but it needs blocks that are not held: go back, then ask for all blocks. */
  void backForAll() {
    needsAll = true;
    goesBack = true;
  }

  /** There is no way: go back, and answer from there. */
  void backForGood() {
    isCutOff = true;
    goesBack = true;
  }

  /** Records the arrival at the destination; returns the answer to give, null for none. */
  @Nullable Answer arrived() {
    Answer whenBack = isCutOff ? Answer.NO_WAY : null;
    Answer answer = goesBack ? whenBack : Answer.REACHED;
    goesBack = false;
    isCutOff = false;
    return answer;
  }

  /** Records the answer to the present goal, returns that goal, and continues with the next one. */
  Goal answer(Answer answer) {
    Goal goal = goals.remove();
    if (answer == Answer.REACHED) {
      rest = goal.at();
    }
    answers.add(goal.name() + " " + answer);
    needsAll = false;
    return goal;
  }

  /** A text with name and answer for each answered goal, in order. */
  List<Object> answers() {
    return List.copyOf(answers);
  }
}

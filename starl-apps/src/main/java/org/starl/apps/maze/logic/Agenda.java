package org.starl.apps.maze.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
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
  private final SortedSet<String> needed = new TreeSet<>();
  private Point rest;
  private boolean goesBack;
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

  /** The blocks of a way to this goal, and those that earlier ways to it have needed. */
  SortedSet<String> withNeeded(Collection<String> blocks) {
    SortedSet<String> all = new TreeSet<>(needed);
    all.addAll(blocks);
    return all;
  }

  /**
   * There is a way, but it needs {@code more} blocks than are {@code held}: go back, then ask for all
   * of these. So what a robot asks for grows each time, until it holds a way or the whole floor.
   */
  void backForMore(Collection<String> held, Collection<String> more) {
    needed.addAll(held);
    needed.addAll(more);
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
    needed.clear();
    return goal;
  }

  /** A text with name and answer for each answered goal, in order. */
  List<Object> answers() {
    return List.copyOf(answers);
  }
}

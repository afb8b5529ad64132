package org.starl.apps.maze.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;

/**
 * What one robot is after: its goals in turn, what has become of them, and whether it is on its way
 * back to where it last stood in nobody's way, and why. Pure.
 */
final class Agenda {

  private static final double BACK_MM = 20;

  private final ArrayDeque<Goal> goals;
  private final List<Object> answers = new ArrayList<>();
  private Point rest;
  private boolean goesBack;
  private boolean needsAll;
  private boolean isCutOff;

  Agenda(Errand errand) {
    goals = new ArrayDeque<>(errand.goals());
    rest = errand.start();
  }

  boolean isDone() {
    return goals.isEmpty();
  }

  /** The goal that it is after; there is one unless all are answered. */
  Goal goal() {
    return goals.element();
  }

  /** Whether it is on its way back, not to its goal. */
  boolean goesBack() {
    return goesBack;
  }

  /** Where it is going. */
  Point to() {
    return goesBack ? rest : goal().at();
  }

  /** Nearer than this is there. */
  double toleranceMm() {
    return goesBack ? BACK_MM : goal().toleranceMm();
  }

  /** Whether nothing less than the whole floor will do for this goal. */
  boolean needsAll() {
    return needsAll;
  }

  /** There is a way, but through others: back, to ask for the whole floor. */
  void backForAll() {
    needsAll = true;
    goesBack = true;
  }

  /** There is no way: back, to say so from there. */
  void backForGood() {
    isCutOff = true;
    goesBack = true;
  }

  /** It has come to where it was going; returns what there is to answer, null for nothing. */
  @Nullable Answer arrived() {
    Answer onWayBack = isCutOff ? Answer.NO_WAY : null;
    Answer answer = goesBack ? onWayBack : Answer.REACHED;
    goesBack = false;
    isCutOff = false;
    return answer;
  }

  /** Notes what becomes of the goal that it is after, and returns that goal; it goes on to the next. */
  Goal answer(Answer answer) {
    Goal goal = goals.remove();
    if (answer == Answer.REACHED) {
      rest = goal.at();
    }
    answers.add(goal.name() + " " + answer);
    needsAll = false;
    return goal;
  }

  /** A goal's name and the answer, in the goals' order. */
  List<Object> answers() {
    return List.copyOf(answers);
  }
}

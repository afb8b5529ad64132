package org.starl.lang.picture;

import java.util.List;

/**
 * A branch on its way from one box to another.
 *
 * @param number of the branch, so that equal ones differ
 * @param from number of its box, from 0 at the top
 * @param to number of the box that it leads to
 * @param guard lines of its condition
 * @param effect lines of what it does
 */
record Arrow(int number, int from, int to, List<String> guard, List<String> effect) {

  /** Whether it leads from one box to the one below, so that it needs no lane. */
  boolean isStraight() {
    return to == from + 1;
  }

  /** Back arrows and loops run on the left of the boxes, arrows that pass boxes on the right. */
  boolean isLeft() {
    return to <= from;
  }

  int top() {
    return Math.min(from, to);
  }

  int bottom() {
    return Math.max(from, to);
  }

  int lines() {
    return guard.size() + effect.size();
  }
}

package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * A part of a room's cells as lengths: so many are not in it, so many are, and so on, in the order of
 * the cells. What would be too long is left out at the end: then it says less than it could, never
 * what is not so.
 */
final class Runs {

  static final int MAX = 200;
  private static final int LONGEST = 0xFFFF;

  private Runs() {}

  /** The lengths of {@code part}, which is of {@code room}'s cells. */
  static List<Integer> of(BitSet part, Room room) {
    List<Integer> runs = new ArrayList<>();
    int[] length = {0};
    boolean[] isIn = {false};
    room.forEachCell(cell -> {
      if (part.get(cell) != isIn[0]) {
        runs.add(Math.min(LONGEST, length[0]));
        length[0] = 0;
        isIn[0] = !isIn[0];
      }
      length[0]++;
    });
    if (isIn[0]) {
      runs.add(Math.min(LONGEST, length[0]));
    }
    return List.copyOf(runs.subList(0, Math.min(MAX, runs.size())));
  }

  /** The cells that {@link #of} was told; of other lengths, whatever they say. */
  static BitSet cells(List<Integer> runs, Room room) {
    BitSet part = new BitSet();
    int[] next = {0};
    int[] left = {runs.isEmpty() ? 0 : runs.get(0)};
    room.forEachCell(cell -> {
      while (left[0] == 0 && next[0] < runs.size()) {
        next[0]++;
        left[0] = next[0] < runs.size() ? runs.get(next[0]) : 0;
      }
      if (next[0] < runs.size()) {
        part.set(cell, next[0] % 2 == 1);
        left[0]--;
      }
    });
    return part;
  }
}

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
    int from = 0;
    for (int i = 0; i < runs.size(); i++) {
      int to = Math.min(room.size(), from + runs.get(i));
      for (int at = from; at < to && i % 2 == 1; at++) {
        part.set(room.cell(at));
      }
      from = to;
    }
    return part;
  }
}

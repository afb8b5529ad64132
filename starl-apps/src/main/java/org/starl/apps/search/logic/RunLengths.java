package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * A part of a room's cells as run lengths: of the room's cells in order, so many are not in the
 * part, so many are, and so on. A list that would be too long is cut at its end: then it names
 * fewer cells, never others.
 */
final class RunLengths {

  static final int MAX = 200;
  private static final int LONGEST = 0xFFFF;

  private RunLengths() {}

  static List<Integer> of(BitSet part, Room room) {
    List<Integer> runs = new ArrayList<>();
    int length = 0;
    boolean isIn = false;
    BitSet cells = room.cells();
    for (int cell = cells.nextSetBit(0); cell >= 0; cell = cells.nextSetBit(cell + 1)) {
      if (part.get(cell) != isIn) {
        runs.add(Math.min(LONGEST, length));
        length = 0;
        isIn = !isIn;
      }
      length++;
    }
    if (isIn) {
      runs.add(Math.min(LONGEST, length));
    }
    return List.copyOf(runs.subList(0, Math.min(MAX, runs.size())));
  }

  /** The part that a list names; of any list of numbers, cells of the room. */
  static BitSet cells(List<Integer> runs, Room room) {
    BitSet part = new BitSet();
    int cell = room.cells().nextSetBit(0);
    for (int i = 0; i < runs.size(); i++) {
      for (int left = runs.get(i); left > 0 && cell >= 0; left--) {
        part.set(cell, i % 2 == 1);
        cell = room.cells().nextSetBit(cell + 1);
      }
    }
    return part;
  }
}

package org.starl.lang.check;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.lang.eval.Domain;

/** A set of states in the order in which they were added, each with the one it was reached from. */
final class States {

  private static final int BLOCK = 4096;
  private static final int FIRST_SLOTS = 1 << 16;

  private final int width;
  private final List<int[]> blocks = new ArrayList<>();

  /** Open addressing; a state's number plus 1, or 0. */
  private int[] slots = new int[FIRST_SLOTS];

  private int size;

  /**
   * @param width the numbers of a state
   */
  States(int width) {
    this.width = width;
  }

  int size() {
    return size;
  }

  /** Forgets the states, but not how many there are: makes room where memory ran out. */
  void clear() {
    blocks.clear();
    slots = new int[1];
  }

  /** The number of a state; below 0 if it is not there. */
  int number(int[] state) {
    return slots[slot(state)] - 1;
  }

  /** Adds a state if it is not there yet; returns its number. */
  int add(int[] state, int parent) {
    int slot = slot(state);
    if (slots[slot] != 0) {
      return slots[slot] - 1;
    }
    if (size % BLOCK == 0) {
      blocks.add(new int[BLOCK * (width + 1)]);
    }
    int at = at(size);
    System.arraycopy(state, 0, blocks.getLast(), at, width);
    blocks.getLast()[at + width] = parent;
    slots[slot] = ++size;
    if (size > slots.length / 2) {
      grow();
    }
    return size - 1;
  }

  int[] get(int number) {
    return Arrays.copyOfRange(blocks.get(number / BLOCK), at(number), at(number) + width);
  }

  /** The state from which it was reached; below 0 for a start state. */
  int parent(int number) {
    return blocks.get(number / BLOCK)[at(number) + width];
  }

  /** The numbers of the states of a shortest run to one. */
  List<Integer> pathTo(int number) {
    List<Integer> path = new ArrayList<>();
    for (int at = number; at >= 0; at = parent(at)) {
      path.addFirst(at);
    }
    return path;
  }

  private int at(int number) {
    return number % BLOCK * (width + 1);
  }

  private int slot(int[] state) {
    int slot = hash(state, 0);
    while (slots[slot] != 0 && !isAt(slots[slot] - 1, state)) {
      slot = slot + 1 & slots.length - 1;
    }
    return slot;
  }

  private int hash(int[] block, int from) {
    long hash = 0;
    for (int i = 0; i < width; i++) {
      hash = Domain.mix(hash, block[from + i]);
    }
    return (int) hash & slots.length - 1;
  }

  private boolean isAt(int number, int[] state) {
    int[] block = blocks.get(number / BLOCK);
    int from = at(number);
    for (int i = 0; i < width; i++) {
      if (block[from + i] != state[i]) {
        return false;
      }
    }
    return true;
  }

  /** The first states: each its numbers, then the one that it was reached from. */
  void write(int first, DataOutput out) throws IOException {
    for (int number = 0; number < first; number++) {
      for (int i = 0; i <= width; i++) {
        out.writeInt(blocks.get(number / BLOCK)[at(number) + i]);
      }
    }
  }

  /** Adds so many states as they were written; there is none yet. */
  void read(int first, DataInput in) throws IOException {
    for (int[] state = new int[width]; size < first; ) {
      for (int i = 0; i < width; i++) {
        state[i] = in.readInt();
      }
      add(state, in.readInt());
    }
  }

  private void grow() {
    slots = new int[slots.length * 2];
    for (int number = 0; number < size; number++) {
      int slot = hash(blocks.get(number / BLOCK), at(number));
      while (slots[slot] != 0) {
        slot = slot + 1 & slots.length - 1;
      }
      slots[slot] = number + 1;
    }
  }
}

package org.starl.sim.kernel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pending events, as parallel arrays: an event is a slot number, and a slot is used again when
 * its event is over, so that scheduling allocates nothing once the table has grown.
 */
final class EventTable {

  /** No slot. */
  static final int NONE = -1;

  private static final int INITIAL_SLOTS = 64;

  long[] atNs = new long[INITIAL_SLOTS];

  /** The number of the scheduling: decides between events of equal time. */
  long[] sequence = new long[INITIAL_SLOTS];

  /** The next slot of the same list; of a free slot, the next free one. */
  int[] next = new int[INITIAL_SLOTS];

  /** Where the queue keeps the slot: an index or a neighbour, as the queue likes. */
  int[] place = new int[INITIAL_SLOTS];

  /** On which strand; null for an event of the world. */
  @Nullable SimStrand[] strand = new SimStrand[INITIAL_SLOTS];

  /** What to run; null in a slot whose event was removed. */
  @Nullable Runnable[] piece = new Runnable[INITIAL_SLOTS];

  private int firstFree = NONE;
  private int everUsed;
  private long lastSequence;

  /** A slot for a new event. */
  int take(long timeNs, @Nullable SimStrand onStrand, Runnable newPiece) {
    int slot = firstFree;
    if (slot != NONE) {
      firstFree = next[slot];
    } else {
      if (everUsed == atNs.length) {
        grow();
      }
      slot = everUsed++;
    }
    atNs[slot] = timeNs;
    sequence[slot] = ++lastSequence;
    strand[slot] = onStrand;
    piece[slot] = newPiece;
    return slot;
  }

  /** Forgets what the slot refers to, but keeps the slot. */
  void clear(int slot) {
    strand[slot] = null;
    piece[slot] = null;
  }

  void release(int slot) {
    clear(slot);
    next[slot] = firstFree;
    firstFree = slot;
  }

  /** The total order of events. */
  boolean isBefore(int slot, int other) {
    return atNs[slot] < atNs[other]
        || (atNs[slot] == atNs[other] && sequence[slot] < sequence[other]);
  }

  private void grow() {
    int slots = 2 * everUsed;
    atNs = Arrays.copyOf(atNs, slots);
    sequence = Arrays.copyOf(sequence, slots);
    next = Arrays.copyOf(next, slots);
    place = Arrays.copyOf(place, slots);
    strand = Arrays.copyOf(strand, slots);
    piece = Arrays.copyOf(piece, slots);
  }
}

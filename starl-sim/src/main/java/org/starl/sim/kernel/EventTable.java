package org.starl.sim.kernel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pending events: an event is a slot number, and a slot is used again when its event is over, so
 * that scheduling allocates nothing once the table has grown. With thousands of robots a slot is cold
 * when its turn comes: so it has but what it is to run, and its place.
 */
final class EventTable {

  /** No slot. */
  static final int NONE = -1;

  private static final int INITIAL_SLOTS = 64;

  /** Of each slot: its strand, then what to run. */
  private @Nullable Object[] work = new Object[2 * INITIAL_SLOTS];

  private int[] places = new int[INITIAL_SLOTS];

  /** Slots whose event is over. */
  private int[] free = new int[INITIAL_SLOTS];

  private int freeCount;
  private int everUsed;

  /** A slot for a new event. */
  int take(@Nullable SimStrand strand, Runnable piece) {
    int slot;
    if (freeCount > 0) {
      slot = free[--freeCount];
    } else {
      if (everUsed == places.length) {
        grow();
      }
      slot = everUsed++;
    }
    work[2 * slot] = strand;
    work[2 * slot + 1] = piece;
    return slot;
  }

  /** Where the queue keeps the slot, as the queue likes. */
  int place(int slot) {
    return places[slot];
  }

  void setPlace(int slot, int place) {
    places[slot] = place;
  }

  /** On which strand; null for an event of the world. */
  @Nullable SimStrand strand(int slot) {
    return (SimStrand) work[2 * slot];
  }

  /** What to run; null in a slot that is not taken. */
  @Nullable Runnable piece(int slot) {
    return (Runnable) work[2 * slot + 1];
  }

  /** Prefetches strand and piece ({@link Cache}). */
  int touch(int slot) {
    return Cache.prefetch(work[2 * slot]) + Cache.prefetch(work[2 * slot + 1]);
  }

  void release(int slot) {
    work[2 * slot] = null;
    work[2 * slot + 1] = null;
    free[freeCount++] = slot;
  }

  private void grow() {
    work = Arrays.copyOf(work, 2 * work.length);
    places = Arrays.copyOf(places, 2 * places.length);
    free = Arrays.copyOf(free, 2 * free.length);
  }
}

package org.starl.sim.kernel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pending events. An event is a slot number; a slot is reused after its event, so that
 * scheduling allocates nothing once the table has grown. A slot holds only the strand, the piece
 * and the place, because with thousands of robots slots are not in the cache when their turn comes.
 */
final class EventTable {

  /** No slot. */
  static final int NONE = -1;

  private static final int INITIAL_SLOTS = 64;

  /** For each slot: its strand, then its piece. */
  private @Nullable Object[] work = new Object[2 * INITIAL_SLOTS];

  private int[] places = new int[INITIAL_SLOTS];

  /** Free slots. */
  private int[] free = new int[INITIAL_SLOTS];

  private int freeCount;
  private int everUsed;

  /** Allocates a slot for a new event. */
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

  /** The slot's place, in the encoding of {@link EventQueue}. */
  int place(int slot) {
    return places[slot];
  }

  void setPlace(int slot, int place) {
    places[slot] = place;
  }

  /** The strand of the event; null for an event of the world. */
  @Nullable SimStrand strand(int slot) {
    return (SimStrand) work[2 * slot];
  }

  /** The piece to run; null for a free slot. */
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

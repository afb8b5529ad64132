package org.starl.sim.kernel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pending events: an event is a slot number, and a slot is used again when its event is over, so
 * that scheduling allocates nothing once the table has grown. What belongs to one slot lies side by
 * side: with thousands of robots a slot is cold when its turn comes, and costs two cache lines.
 */
final class EventTable {

  /** No slot. */
  static final int NONE = -1;

  private static final int INITIAL_SLOTS = 64;

  private static final int LONGS = 3;
  private static final long LOWER_HALF = (1L << Integer.SIZE) - 1;

  /**
   * Of each slot: when; the next one of its list, in the upper half, and where the queue keeps it;
   * and, seldom read, the number of its scheduling.
   */
  private long[] keys = new long[LONGS * INITIAL_SLOTS];

  /** Of each slot: its strand, then what to run. */
  private @Nullable Object[] work = new Object[2 * INITIAL_SLOTS];

  private int firstFree = NONE;
  private int everUsed;
  private long lastSequence;

  /** A slot for a new event. */
  int take(long atNs, @Nullable SimStrand strand, Runnable piece) {
    int slot = firstFree;
    if (slot != NONE) {
      firstFree = next(slot);
    } else {
      if (LONGS * everUsed == keys.length) {
        grow();
      }
      slot = everUsed++;
    }
    keys[LONGS * slot] = atNs;
    // Decides between events of equal time.
    keys[LONGS * slot + 2] = ++lastSequence;
    work[2 * slot] = strand;
    work[2 * slot + 1] = piece;
    return slot;
  }

  long atNs(int slot) {
    return keys[LONGS * slot];
  }

  /** The next slot of the same list; of a free slot, the next free one. */
  int next(int slot) {
    return (int) (keys[LONGS * slot + 1] >>> Integer.SIZE);
  }

  void setNext(int slot, int next) {
    int links = LONGS * slot + 1;
    keys[links] = (long) next << Integer.SIZE | (keys[links] & LOWER_HALF);
  }

  /** Where the queue keeps the slot: an index or a neighbour, as the queue likes. */
  int place(int slot) {
    return (int) keys[LONGS * slot + 1];
  }

  void setPlace(int slot, int place) {
    int links = LONGS * slot + 1;
    keys[links] = (keys[links] & ~LOWER_HALF) | (place & LOWER_HALF);
  }

  /** On which strand; null for an event of the world. */
  @Nullable SimStrand strand(int slot) {
    return (SimStrand) work[2 * slot];
  }

  /** What to run; null in a slot whose event was removed. */
  @Nullable Runnable piece(int slot) {
    return (Runnable) work[2 * slot + 1];
  }

  /** Touches strand and piece ({@link Cache}). */
  int touch(int slot) {
    return Cache.touch(work[2 * slot]) + Cache.touch(work[2 * slot + 1]);
  }

  /** Forgets what the slot refers to, but keeps the slot. */
  void clear(int slot) {
    work[2 * slot] = null;
    work[2 * slot + 1] = null;
  }

  void release(int slot) {
    clear(slot);
    setNext(slot, firstFree);
    firstFree = slot;
  }

  /** The total order of events. */
  boolean isBefore(int slot, int other) {
    long atNs = atNs(slot);
    long otherAtNs = atNs(other);
    return atNs < otherAtNs
        || (atNs == otherAtNs && keys[LONGS * slot + 2] < keys[LONGS * other + 2]);
  }

  private void grow() {
    keys = Arrays.copyOf(keys, 2 * keys.length);
    work = Arrays.copyOf(work, 2 * work.length);
  }
}

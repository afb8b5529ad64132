package org.starl.sim.kernel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pending events: an event is a slot number, and a slot is used again when its event is over, so
 * that scheduling allocates nothing once the table has grown. What belongs to one slot lies side by
 * side: with thousands of robots a slot is cold when its turn comes, and costs three cache lines.
 */
final class EventTable {

  /** No slot. */
  static final int NONE = -1;

  private static final int INITIAL_SLOTS = 64;

  /** Of each slot: when, then the number of its scheduling. */
  private long[] keys = new long[2 * INITIAL_SLOTS];

  /** Of each slot: the next one of its list, then where the queue keeps it. */
  private int[] links = new int[2 * INITIAL_SLOTS];

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
      if (2 * everUsed == keys.length) {
        grow();
      }
      slot = everUsed++;
    }
    keys[2 * slot] = atNs;
    // Decides between events of equal time.
    keys[2 * slot + 1] = ++lastSequence;
    work[2 * slot] = strand;
    work[2 * slot + 1] = piece;
    return slot;
  }

  long atNs(int slot) {
    return keys[2 * slot];
  }

  /** The next slot of the same list; of a free slot, the next free one. */
  int next(int slot) {
    return links[2 * slot];
  }

  void setNext(int slot, int next) {
    links[2 * slot] = next;
  }

  /** Where the queue keeps the slot: an index or a neighbour, as the queue likes. */
  int place(int slot) {
    return links[2 * slot + 1];
  }

  void setPlace(int slot, int place) {
    links[2 * slot + 1] = place;
  }

  /** On which strand; null for an event of the world. */
  @Nullable SimStrand strand(int slot) {
    return (SimStrand) work[2 * slot];
  }

  /** What to run; null in a slot whose event was removed. */
  @Nullable Runnable piece(int slot) {
    return (Runnable) work[2 * slot + 1];
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
    return atNs < otherAtNs || (atNs == otherAtNs && keys[2 * slot + 1] < keys[2 * other + 1]);
  }

  private void grow() {
    keys = Arrays.copyOf(keys, 2 * keys.length);
    links = Arrays.copyOf(links, 2 * links.length);
    work = Arrays.copyOf(work, 2 * work.length);
  }
}

package org.starl.sim.kernel;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Events in the total order (time, number of scheduling), each with the strand and the piece to run.
 *
 * <p>A ring of buckets, each {@code 2^16} ns wide, holds the next two seconds; a bucket is a linked
 * list that is sorted when its turn comes. What lies beyond the ring waits in a heap, and so does
 * what is added for the bucket that is open or for an earlier one. Empty buckets are skipped 64 at a
 * time. Adding and removing cost constant time in the ring, and no removed event stays behind.
 */
final class EventQueue {

  private static final int BUCKET_SHIFT = 16;
  private static final long OFFSET_MASK = (1L << BUCKET_SHIFT) - 1;
  private static final int BUCKETS = 1 << 15;
  private static final int BUCKET_MASK = BUCKETS - 1;

  // So many events' memory is fetched at once: of fewer it is not worth it, more would push each
  // other
  // out of the cache again before they run.
  private static final int LEAST_AHEAD = 4;
  private static final int MOST_AHEAD = 16;

  /** The {@code place} of a slot in the open bucket; elsewhere places are -1 or above. */
  private static final int OPEN = -2;

  private final EventTable events = new EventTable();

  // A bucket's newest slot, valid where its bit is set. Older ones follow by next, newer by place.
  private final int[] newest = new int[BUCKETS];
  private final long[] occupied = new long[BUCKETS / Long.SIZE];
  private int slotsInRing;

  // The bucket whose turn it is, sorted: offset in the bucket << 32 | order of scheduling.
  private long openBucket = -1;
  private long[] openKeys = new long[16];
  private int[] openSlots = new int[16];
  private int openNext;
  private int openEnd;

  // How many events of the open bucket were touched; and a slot of the next bucket's list, which is
  // walked ahead, a step an event. Both for the cache alone: they decide nothing.
  private int touchedTo;
  private int scout = EventTable.NONE;

  @SuppressWarnings("UnusedVariable") // kept, or the compiler would leave the reading out (Cache)
  private int read;

  private final SlotHeap near = new SlotHeap(events);
  private final SlotHeap far = new SlotHeap(events);
  private int size;

  private long polledAtNs;
  private @Nullable SimStrand polledStrand;
  private @Nullable Runnable polledPiece;

  int size() {
    return size;
  }

  /**
   * Adds an event.
   *
   * @param atNs not negative, and not before the event polled last
   * @return its slot, for {@link #remove}, until it is polled
   */
  int add(long atNs, @Nullable SimStrand strand, Runnable piece) {
    int slot = events.take(atNs, strand, piece);
    size++;
    long bucketsAhead = (atNs >>> BUCKET_SHIFT) - openBucket;
    if (bucketsAhead <= 0) {
      near.add(slot);
    } else if (bucketsAhead < BUCKETS) {
      addToRing(slot);
    } else {
      far.add(slot);
    }
    return slot;
  }

  /** Removes the event in {@code slot}, which must not have been polled or removed. */
  void remove(int slot) {
    size--;
    long bucketsAhead = (events.atNs(slot) >>> BUCKET_SHIFT) - openBucket;
    if (events.place(slot) == OPEN) {
      events.clear(slot);
      return;
    }
    if (bucketsAhead <= 0) {
      near.removeAt(events.place(slot));
    } else if (bucketsAhead < BUCKETS) {
      removeFromRing(slot);
    } else {
      far.removeAt(events.place(slot));
    }
    events.release(slot);
  }

  /**
   * Takes the earliest event out, unless it is later than {@code untilNs}.
   *
   * @return whether there was one; {@link #atNs}, {@link #strand} and {@link #piece} are its
   */
  boolean poll(long untilNs) {
    int slot = first();
    if (slot == EventTable.NONE || events.atNs(slot) > untilNs) {
      return false;
    }
    if (events.place(slot) == OPEN) {
      openNext++;
    } else {
      near.removeAt(0);
    }
    if (scout != EventTable.NONE) {
      scout = events.next(scout);
    }
    size--;
    polledAtNs = events.atNs(slot);
    polledStrand = events.strand(slot);
    polledPiece = events.piece(slot);
    events.release(slot);
    return true;
  }

  long atNs() {
    return polledAtNs;
  }

  /** The strand of the polled event, or null if it is the world's. */
  @Nullable SimStrand strand() {
    return polledStrand;
  }

  Runnable piece() {
    if (polledPiece == null) {
      throw new IllegalStateException("nothing was polled");
    }
    return polledPiece;
  }

  private int first() {
    while (true) {
      int open = firstOpen();
      int added = near.first();
      if (open != EventTable.NONE) {
        // At equal times the open bucket's event is the older one: it was there when it opened.
        boolean overtaken = added != EventTable.NONE && events.atNs(added) < events.atNs(open);
        return overtaken ? added : open;
      }
      if (added != EventTable.NONE || !openNextBucket()) {
        return added;
      }
    }
  }

  private int firstOpen() {
    while (openNext < openEnd) {
      if (openNext >= touchedTo) {
        touchAhead();
      }
      int slot = openSlot(openNext);
      if (events.piece(slot) != null) {
        return slot;
      }
      events.release(slot);
      openNext++;
    }
    return EventTable.NONE;
  }

  private int openSlot(int index) {
    return openSlots[Integer.MAX_VALUE - (int) openKeys[index]];
  }

  /**
   * Lets the next events' memory come into the cache together: with thousands of robots each event
   * follows some thirty references through memory that is cold, and would wait for one after the
   * other.
   */
  private void touchAhead() {
    int from = openNext;
    int to = Math.min(from + MOST_AHEAD, openEnd);
    touchedTo = to;
    if (to - from < LEAST_AHEAD) {
      return;
    }
    int sum = 0;
    for (int i = from; i < to; i++) {
      sum += events.touch(openSlot(i));
    }
    for (int i = from; i < to; i++) {
      SimStrand strand = events.strand(openSlot(i));
      Runnable piece = events.piece(openSlot(i));
      if (strand != null && piece != null) {
        sum += strand.touch(piece);
      }
    }
    read = sum;
  }

  private boolean openNextBucket() {
    if (slotsInRing > 0) {
      int bucket = (int) openBucket & BUCKET_MASK;
      openBucket += 1 + ((occupiedAfter(bucket) - bucket - 1) & BUCKET_MASK);
    } else if (!far.isEmpty()) {
      openBucket = events.atNs(far.first()) >>> BUCKET_SHIFT;
    } else {
      return false;
    }
    while (!far.isEmpty() && (events.atNs(far.first()) >>> BUCKET_SHIFT) - openBucket < BUCKETS) {
      int slot = far.first();
      far.removeAt(0);
      addToRing(slot);
    }
    sortOpenBucket();
    return true;
  }

  private void sortOpenBucket() {
    int bucket = (int) openBucket & BUCKET_MASK;
    occupied[bucket >>> 6] &= ~(1L << bucket);
    int count = 0;
    for (int slot = newest[bucket]; slot != EventTable.NONE; slot = events.next(slot)) {
      if (count == openKeys.length) {
        openKeys = Arrays.copyOf(openKeys, 2 * count);
        openSlots = Arrays.copyOf(openSlots, 2 * count);
      }
      // The list runs from the newest to the oldest, so later ones get the lower key.
      openKeys[count] = (events.atNs(slot) & OFFSET_MASK) << 32 | (Integer.MAX_VALUE - count);
      openSlots[count] = slot;
      events.setPlace(slot, OPEN);
      count++;
    }
    Arrays.sort(openKeys, 0, count);
    touchedTo = 0;
    slotsInRing -= count;
    openNext = 0;
    openEnd = count;
    scout = slotsInRing == 0 ? EventTable.NONE : newest[occupiedAfter(bucket)];
  }

  /** The first occupied bucket of the ring after {@code bucket}; there is one. */
  private int occupiedAfter(int bucket) {
    int start = (bucket + 1) & BUCKET_MASK;
    int word = start >>> 6;
    long bits = occupied[word] & (-1L << start);
    while (bits == 0) {
      word = (word + 1) & (occupied.length - 1);
      bits = occupied[word];
    }
    return (word << 6) + Long.numberOfTrailingZeros(bits);
  }

  private void addToRing(int slot) {
    int bucket = (int) (events.atNs(slot) >>> BUCKET_SHIFT) & BUCKET_MASK;
    long bit = 1L << bucket;
    if ((occupied[bucket >>> 6] & bit) == 0) {
      occupied[bucket >>> 6] |= bit;
      events.setNext(slot, EventTable.NONE);
    } else {
      events.setNext(slot, newest[bucket]);
      events.setPlace(newest[bucket], slot);
    }
    events.setPlace(slot, EventTable.NONE);
    newest[bucket] = slot;
    slotsInRing++;
  }

  private void removeFromRing(int slot) {
    int bucket = (int) (events.atNs(slot) >>> BUCKET_SHIFT) & BUCKET_MASK;
    int newer = events.place(slot);
    int older = events.next(slot);
    if (newer != EventTable.NONE) {
      events.setNext(newer, older);
    } else if (older != EventTable.NONE) {
      newest[bucket] = older;
    } else {
      occupied[bucket >>> 6] &= ~(1L << bucket);
    }
    if (older != EventTable.NONE) {
      events.setPlace(older, newer);
    }
    slotsInRing--;
  }
}

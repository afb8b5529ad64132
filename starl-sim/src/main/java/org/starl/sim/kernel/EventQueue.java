package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;

/**
 * Events in the total order (time, scheduling number), each with its strand and the piece to run.
 *
 * <p>A ring of buckets, each {@code 2^16} ns wide, holds the next two seconds; a bucket is sorted
 * when it is opened. Later events wait in a heap, and so do events that are added to the open
 * bucket or to an earlier one.
 */
final class EventQueue {

  private static final int BUCKET_SHIFT = 16;
  private static final int OFFSET_MASK = (1 << BUCKET_SHIFT) - 1;

  // The number of events that are prefetched together. Fewer give no benefit; more would evict each
  // other from the cache before they run.
  private static final int LEAST_AHEAD = 4;
  private static final int MOST_AHEAD = 16;

  private final EventTable events = new EventTable();

  // The place of a slot: if negative, the complement of its cell in the ring; otherwise a heap
  // index.
  private final BucketRing ring = new BucketRing();
  private final SlotHeap near = new SlotHeap(events, 0);
  private final SlotHeap far = new SlotHeap(events, SlotHeap.MARK_BIT);
  private long openBucket = -1;
  private int size;

  // How many events of the open bucket were touched: for the cache alone, it decides nothing.
  private int touchedTo;

  @SuppressWarnings("UnusedVariable") // kept, or the compiler would leave the reading out (Cache)
  private int read;

  private long polledAtNs;
  private @Nullable SimStrand polledStrand;
  private @Nullable Runnable polledPiece;

  int size() {
    return size;
  }

  /**
   * Adds an event.
   *
   * @param atNs at least 0, and not before the event polled last
   * @return its slot, for {@link #remove}, until it is polled
   */
  int add(long atNs, @Nullable SimStrand strand, Runnable piece) {
    int slot = events.take(strand, piece);
    size++;
    long bucketsAhead = (atNs >>> BUCKET_SHIFT) - openBucket;
    if (bucketsAhead <= 0) {
      near.add(slot, atNs);
    } else if (bucketsAhead < BucketRing.BUCKETS) {
      addToRing(slot, atNs);
    } else {
      far.add(slot, atNs);
    }
    return slot;
  }

  /** Removes the event in {@code slot}, which must not have been polled or removed. */
  void remove(int slot) {
    size--;
    int place = events.place(slot);
    if (place < 0) {
      ring.remove(~place);
    } else {
      ((place & SlotHeap.MARK_BIT) == 0 ? near : far).remove(place);
    }
    events.release(slot);
  }

  /**
   * Removes the earliest event unless it is later than {@code untilNs}.
   *
   * @return whether an event was removed; {@link #atNs}, {@link #strand} and {@link #piece}
   *     describe it
   */
  boolean poll(long untilNs) {
    int slot = firstOfRing();
    long atNs = near.firstAtNs();
    // At equal times the ring's event is older: it was added before its bucket was opened.
    boolean isRings = slot != EventTable.NONE && openAtNs() <= atNs;
    if (isRings) {
      atNs = openAtNs();
    } else {
      slot = near.first();
    }
    if (slot == EventTable.NONE || atNs > untilNs) {
      return false;
    }
    if (isRings) {
      ring.take();
    } else {
      near.removeFirst();
    }
    size--;
    polledAtNs = atNs;
    polledStrand = events.strand(slot);
    polledPiece = events.piece(slot);
    events.release(slot);
    return true;
  }

  long atNs() {
    return polledAtNs;
  }

  /** The strand of the polled event, or null for an event of the world. */
  @Nullable SimStrand strand() {
    return polledStrand;
  }

  Runnable piece() {
    if (polledPiece == null) {
      throw new IllegalStateException("nothing was polled");
    }
    return polledPiece;
  }

  /** The first slot of the open bucket. Opens the next bucket if no other event comes before it. */
  private int firstOfRing() {
    do {
      while (ring.next() < ring.end()) {
        if (ring.next() >= touchedTo) {
          touchAhead();
        }
        int slot = ring.slot(ring.next());
        if (slot != EventTable.NONE) {
          return slot;
        }
        ring.take();
      }
    } while (near.isEmpty() && openNextBucket());
    return EventTable.NONE;
  }

  private long openAtNs() {
    return (openBucket << BUCKET_SHIFT) + ring.nextOffset();
  }

  /**
   * Prefetches the memory of the next events together. With thousands of robots each event follows
   * about thirty references through uncached memory; without prefetching it would wait for each in
   * turn.
   */
  private void touchAhead() {
    int from = ring.next();
    int to = Math.min(from + MOST_AHEAD, ring.end());
    touchedTo = to;
    if (to - from < LEAST_AHEAD) {
      return;
    }
    int sum = 0;
    for (int i = from; i < to; i++) {
      int slot = ring.slot(i);
      if (slot != EventTable.NONE) {
        sum += events.touch(slot);
      }
    }
    for (int i = from; i < to; i++) {
      int slot = ring.slot(i);
      if (slot != EventTable.NONE) {
        sum += touch(events.strand(slot), events.piece(slot));
      }
    }
    read = sum;
  }

  private static int touch(@Nullable SimStrand strand, @Nullable Runnable piece) {
    return strand == null || piece == null ? 0 : strand.touch(piece);
  }

  private boolean openNextBucket() {
    if (!ring.isEmpty()) {
      openBucket += ring.distanceToNext(openBucket);
    } else if (!far.isEmpty()) {
      openBucket = far.firstAtNs() >>> BUCKET_SHIFT;
    } else {
      return false;
    }
    while (!far.isEmpty() && (far.firstAtNs() >>> BUCKET_SHIFT) - openBucket < BucketRing.BUCKETS) {
      int slot = far.first();
      long atNs = far.firstAtNs();
      far.removeFirst();
      addToRing(slot, atNs);
    }
    ring.open(openBucket);
    touchedTo = 0;
    return true;
  }

  private void addToRing(int slot, long atNs) {
    int cell = ring.add(atNs >>> BUCKET_SHIFT, (int) atNs & OFFSET_MASK, slot);
    events.setPlace(slot, ~cell);
  }
}

package org.starl.sim.kernel;

import java.util.Arrays;

/**
 * A ring of buckets of events. One bucket is open: its events are taken in order. The events of a
 * bucket are stored in insertion order in chunks of fifteen cells, so that opening a bucket reads
 * memory sequentially. Empty buckets are skipped 64 at a time. Adding and removing cost constant
 * time; a removed event keeps a cell of 8 bytes until its bucket is closed.
 */
final class BucketRing {

  /** A power of 2. */
  static final int BUCKETS = 1 << 15;

  private static final int BUCKET_MASK = BUCKETS - 1;

  /**
   * The first cell of a chunk: a link to the previous chunk, or of a free chunk to the next free
   * one.
   */
  private static final int CHUNK = 16;

  private static final int NO_CHUNK = -1;
  private static final long REMOVED = -1;

  /** An event: its offset within the bucket in the upper half, its slot in the lower half. */
  private long[] cells = new long[64 * CHUNK];

  private int everUsed;
  private int firstFree = NO_CHUNK;

  // The newest cell of each bucket, valid if its bit is set.
  private final int[] newest = new int[BUCKETS];
  private final long[] occupied = new long[BUCKETS / Long.SIZE];
  private int occupiedCount;

  // The open bucket: its newest chunk; its events in order, as offset << 32 | cell index; the
  // number of events, and the number of events taken.
  private int openChunk = NO_CHUNK;
  private long[] openKeys = new long[CHUNK];
  private int[] openCells = new int[CHUNK];
  private int openEnd;
  private int openNext;

  /**
   * Whether all buckets but the open one are empty. A bucket that has only removed events is not
   * empty.
   */
  boolean isEmpty() {
    return occupiedCount == 0;
  }

  /** The number of cells, used or free. */
  int room() {
    return cells.length;
  }

  /**
   * Adds an event to a bucket that is not open.
   *
   * @param bucket any number; numbers with equal lowest bits denote the same bucket
   * @return the event's cell, for {@link #remove}
   */
  int add(long bucket, int offset, int slot) {
    int index = (int) bucket & BUCKET_MASK;
    long bit = 1L << index;
    int cell;
    if ((occupied[index >>> 6] & bit) == 0) {
      occupied[index >>> 6] |= bit;
      occupiedCount++;
      cell = takeChunk(NO_CHUNK) + 1;
    } else {
      cell = newest[index] + 1;
      if (cell % CHUNK == 0) {
        cell = takeChunk(cell - CHUNK) + 1;
      }
    }
    cells[cell] = (long) offset << Integer.SIZE | slot;
    newest[index] = cell;
    return cell;
  }

  /** Removes an event that has not been taken. */
  void remove(int cell) {
    cells[cell] = REMOVED;
  }

  /** The distance from {@code bucket} to the next non-empty bucket, which must exist. */
  int distanceToNext(long bucket) {
    int start = ((int) bucket + 1) & BUCKET_MASK;
    int word = start >>> 6;
    long bits = occupied[word] & (-1L << start);
    while (bits == 0) {
      word = (word + 1) & (occupied.length - 1);
      bits = occupied[word];
    }
    int found = (word << 6) + Long.numberOfTrailingZeros(bits);
    return 1 + ((found - start) & BUCKET_MASK);
  }

  /** Closes the open bucket, which is past, and opens a non-empty one. */
  void open(long bucket) {
    freeOpenChunks();
    int index = (int) bucket & BUCKET_MASK;
    occupied[index >>> 6] &= ~(1L << index);
    occupiedCount--;
    int cell = newest[index];
    openChunk = cell & -CHUNK;
    openEnd = 0;
    openNext = 0;
    for (int chunk = openChunk; chunk != NO_CHUNK; chunk = (int) cells[chunk]) {
      for (; cell > chunk; cell--) {
        if (cells[cell] != REMOVED) {
          addOlderToOpen(cell);
        }
      }
      cell = (int) cells[chunk] + CHUNK - 1;
    }
    Arrays.sort(openKeys, 0, openEnd);
  }

  // Of events of equal time, the one added earlier comes first; this loop meets it later.
  private void addOlderToOpen(int cell) {
    if (openEnd == openKeys.length) {
      openKeys = Arrays.copyOf(openKeys, 2 * openEnd);
      openCells = Arrays.copyOf(openCells, 2 * openEnd);
    }
    openKeys[openEnd] = (cells[cell] & -1L << Integer.SIZE) | (Integer.MAX_VALUE - openEnd);
    openCells[openEnd] = cell;
    openEnd++;
  }

  /**
   * The slot of an event of the open bucket, or {@link EventTable#NONE} if it was removed.
   *
   * @param index the event's index in order, at least {@link #next} and less than {@link #end}
   */
  int slot(int index) {
    return (int) cells[openCells[Integer.MAX_VALUE - (int) openKeys[index]]];
  }

  /** The offset within the open bucket of its next event. */
  int nextOffset() {
    return (int) (openKeys[openNext] >>> Integer.SIZE);
  }

  /** The number of events taken from the open bucket. */
  int next() {
    return openNext;
  }

  /** The number of events of the open bucket, taken ones included. */
  int end() {
    return openEnd;
  }

  void take() {
    openNext++;
  }

  private void freeOpenChunks() {
    int chunk = openChunk;
    while (chunk != NO_CHUNK) {
      int before = (int) cells[chunk];
      cells[chunk] = firstFree;
      firstFree = chunk;
      chunk = before;
    }
  }

  /** Allocates a chunk that links to {@code before}, and returns its first cell. */
  private int takeChunk(int before) {
    int chunk = firstFree;
    if (chunk != NO_CHUNK) {
      firstFree = (int) cells[chunk];
    } else {
      if (everUsed == cells.length) {
        cells = Arrays.copyOf(cells, 2 * cells.length);
      }
      chunk = everUsed;
      everUsed += CHUNK;
    }
    cells[chunk] = before;
    return chunk;
  }
}

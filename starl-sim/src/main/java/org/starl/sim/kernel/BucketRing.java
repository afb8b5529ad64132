package org.starl.sim.kernel;

import java.util.Arrays;

/**
 * A ring of buckets of events, of which one is open: its events are taken, in their order. A bucket's
 * events lie in chunks of fifteen cells, in the order in which they were added, so that one whose turn
 * comes is read at one stretch. Empty buckets are skipped 64 at a time. Adding and removing cost
 * constant time; of a removed event a cell of 8 bytes stays until its bucket is closed.
 */
final class BucketRing {

  /** A power of 2. */
  static final int BUCKETS = 1 << 15;

  private static final int BUCKET_MASK = BUCKETS - 1;

  /** A cell that leads to the chunk before, or of a free chunk to the next free one; then events. */
  private static final int CHUNK = 16;

  private static final int NO_CHUNK = -1;
  private static final long REMOVED = -1;

  /** An event: its offset in the bucket's time in the upper half, its slot in the lower. */
  private long[] cells = new long[64 * CHUNK];

  private int everUsed;
  private int firstFree = NO_CHUNK;

  // A bucket's newest cell, valid where its bit is set.
  private final int[] newest = new int[BUCKETS];
  private final long[] occupied = new long[BUCKETS / Long.SIZE];
  private int occupiedCount;

  // The open bucket: its newest chunk; its events in their order, as offset << 32 | what tells the
  // cell; how many there are, and how many were taken.
  private int openChunk = NO_CHUNK;
  private long[] openKeys = new long[CHUNK];
  private int[] openCells = new int[CHUNK];
  private int openEnd;
  private int openNext;

  /** Whether all buckets are empty but the open one; one that has only removed events is not. */
  boolean isEmpty() {
    return occupiedCount == 0;
  }

  /** How many cells there are, used or not. */
  int room() {
    return cells.length;
  }

  /**
   * Adds an event to a bucket that is not open.
   *
   * @param bucket any number; those that are equal in their lowest bits are the same bucket
   * @return its cell, for {@link #remove}
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

  /** Removes an event that was not taken. */
  void remove(int cell) {
    cells[cell] = REMOVED;
  }

  /** How far it is from {@code bucket} to the next one that is not empty; there is one. */
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

  /** Opens a bucket that is not empty, and closes the one that was open, which is over. */
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

  // Of equal times the earlier one is the one that was added earlier, which comes here later.
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
   * @param index which one in their order, at least {@link #next} and less than {@link #end}
   */
  int slot(int index) {
    return (int) cells[openCells[Integer.MAX_VALUE - (int) openKeys[index]]];
  }

  /** How far into its bucket's time the event is that is next in the open bucket. */
  int nextOffset() {
    return (int) (openKeys[openNext] >>> Integer.SIZE);
  }

  /** How many events of the open bucket were taken. */
  int next() {
    return openNext;
  }

  /** How many events there are in the open bucket, those that were taken included. */
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

  /** A chunk, by its first cell, which leads to {@code before}. */
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

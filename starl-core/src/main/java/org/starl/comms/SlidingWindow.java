package org.starl.comms;

import java.util.Arrays;

/** Which of the {@code size} highest numbers, counted from 1, have been seen. */
final class SlidingWindow {

  private final int size;
  private final long[] seen;
  private long highest;

  /**
   * @param size a power of 2, at least 64
   */
  SlidingWindow(int size) {
    this.size = size;
    this.seen = new long[size / Long.SIZE];
  }

  /** Whether {@code number} is below the window: it is unknown whether it was seen. */
  boolean isTooOld(long number) {
    return number <= highest - size;
  }

  /** Whether {@code number}, which is not too old, was seen. */
  boolean contains(long number) {
    return number <= highest && (seen[word(number)] & bit(number)) != 0;
  }

  /** Sees {@code number}, which is not too old. */
  void add(long number) {
    if (number - highest >= size) {
      Arrays.fill(seen, 0);
    } else {
      for (long skipped = highest + 1; skipped < number; skipped++) {
        seen[word(skipped)] &= ~bit(skipped);
      }
    }
    if (number > highest) {
      highest = number;
    }
    seen[word(number)] |= bit(number);
  }

  private int word(long number) {
    return (int) (number & (size - 1)) / Long.SIZE;
  }

  private static long bit(long number) {
    return 1L << number;
  }
}

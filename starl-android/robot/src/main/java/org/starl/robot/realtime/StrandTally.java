package org.starl.robot.realtime;

/**
 * A histogram of the lengths of a strand's pieces; a length is counted as at most a quarter longer
 * than it was. By hand, so that a phone needs no library for it. The caller guards it by a lock.
 */
final class StrandTally {

  /** Counters for each power of two. */
  private static final int PARTS = 4;

  private static final int PART_BITS = 2;

  private final long[] counts = new long[PARTS * Long.SIZE];
  private long pieces;
  private long heldNs;
  private long longestNs;
  private String longestBy = "no piece";

  void add(long pieceNs, String by) {
    long ns = Math.max(0, pieceNs);
    counts[slot(ns)]++;
    pieces++;
    heldNs += ns;
    if (ns > longestNs) {
      longestNs = ns;
      longestBy = by;
    }
  }

  StrandUse use() {
    return new StrandUse(pieces, heldNs, part(0.5), part(0.99), longestNs, longestBy);
  }

  /** The length that this fraction of the pieces does not exceed. */
  private long part(double part) {
    long below = (long) Math.ceil(part * pieces);
    long seen = 0;
    for (int slot = 0; slot < counts.length && below > 0; slot++) {
      seen += counts[slot];
      if (seen >= below) {
        return Math.min(longestNs, most(slot));
      }
    }
    return 0;
  }

  private static int slot(long ns) {
    if (ns < PARTS) {
      return (int) ns;
    }
    int bits = Long.SIZE - 1 - Long.numberOfLeadingZeros(ns);
    int part = (int) (ns >>> (bits - PART_BITS)) & (PARTS - 1);
    return (bits - 1) * PARTS + part;
  }

  /** The longest length that a slot counts. */
  private static long most(int slot) {
    if (slot < PARTS) {
      return slot;
    }
    int bits = slot / PARTS + 1;
    long part = slot % PARTS;
    return ((PARTS + part + 1) << (bits - PART_BITS)) - 1;
  }
}

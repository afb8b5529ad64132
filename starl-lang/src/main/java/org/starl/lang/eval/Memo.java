package org.starl.lang.eval;

/** What was found for the numbers of some parts; some of it is forgotten where there is no room. */
final class Memo {

  private static final int FIRST = 1 << 8;

  /** So many slots it has at most if little is found again, and if much is. */
  private static final int FEW = 1 << 13;

  private static final int MOST = 1 << 17;
  private static final long SPREAD = 0x9E3779B97F4A7C15L;

  private final int kinds;
  private final int[] parts;

  /** The numbers of a slot: what was found, or 0; then the kind and the numbers of the parts. */
  private final int width;

  private int size = FIRST;
  private int[] slots;
  private int hits;
  private int lost;

  /**
   * @param kinds the number of kinds; 0 if nothing is to be remembered
   */
  Memo(int kinds, Reads of) {
    this.kinds = kinds;
    parts = of.parts();
    width = parts.length + 2;
    slots = new int[size * width];
  }

  /** What was found; 0 if it is not known. */
  int get(int[] state, int kind) {
    int at = slot(state, kind);
    boolean isFound = slots[at] != 0 && slots[at + 1] == kind;
    for (int i = 0; i < parts.length && isFound; i++) {
      isFound = slots[at + 2 + i] == state[parts[i]];
    }
    hits += isFound ? 1 : 0;
    return isFound ? slots[at] : 0;
  }

  /** Remembers what was found, if it is above 0. */
  void put(int[] state, int kind, int found) {
    if (found <= 0 || kinds == 0) {
      return;
    }
    int at = slot(state, kind);
    if (slots[at] != 0 && ++lost > size / 4) {
      if (size < (hits > lost / 4 ? MOST : FEW)) {
        size *= 4;
        slots = new int[size * width]; // it fills again
        at = slot(state, kind);
      }
      hits = 0;
      lost = 0;
    }
    slots[at] = found;
    slots[at + 1] = kind;
    for (int i = 0; i < parts.length; i++) {
      slots[at + 2 + i] = state[parts[i]];
    }
  }

  /** Numbers begin with 0: those of one part, with their kinds, are neighbours, and are spread evenly. */
  private int slot(int[] state, int kind) {
    long hash = 0;
    for (int part : parts) {
      hash = hash * SPREAD + state[part];
    }
    hash = (hash * kinds + kind) * SPREAD;
    return (int) (hash >>> (Long.numberOfLeadingZeros(size) + 1)) * width;
  }
}

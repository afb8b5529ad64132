package org.starl.sim.view.page;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Encodes a list of items, each an array of numbers, as its differences to the list before it. An
 * entry of the result is
 *
 * <ul>
 *   <li>a number n: the next n items are those of the list before;
 *   <li>{@code [-1, style, dx, dy]}: the previous item of this list, moved, in another style;
 *   <li>{@code [head, tail, numbers...]}: the first {@code head} numbers of the item with the same
 *       index in the list before, then {@code numbers}, then its last {@code tail} numbers.
 * </ul>
 */
final class FrameEncoder {

  /** Index of the first coordinate in an item of each {@link DrawnItem} kind; 0 if it varies. */
  private static final int[] COORDINATES = {2, 2, 4, 4, 5, 0};

  private static final int[] NONE = {};

  private List<int[]> before = List.of();

  /** Encodes the next list; returns an empty one if nothing changed. */
  List<Object> next(List<int[]> items) {
    List<Object> changes = new ArrayList<>();
    int same = 0;
    for (int i = 0; i < items.size(); i++) {
      int[] item = items.get(i);
      int[] old = i < before.size() ? before.get(i) : NONE;
      if (Arrays.equals(item, old)) {
        same++;
      } else {
        if (same > 0) {
          changes.add(same);
        }
        same = 0;
        changes.add(
            i > 0 && isMoved(items.get(i - 1), item)
                ? moved(items.get(i - 1), item)
                : changed(old, item));
      }
    }
    boolean isSame = changes.isEmpty() && items.size() == before.size();
    if (same > 0 && !isSame) {
      changes.add(same);
    }
    before = List.copyOf(items);
    if (!isSame && changes.isEmpty()) {
      changes.add(0);
    }
    return isSame ? List.of() : changes;
  }

  private static int[] changed(int[] old, int[] item) {
    int shorter = Math.min(old.length, item.length);
    int mismatch = Arrays.mismatch(old, item);
    int head = mismatch < 0 ? shorter : mismatch;
    int tail = 0;
    while (tail < shorter - head && old[old.length - 1 - tail] == item[item.length - 1 - tail]) {
      tail++;
    }
    int[] change = new int[2 + item.length - head - tail];
    change[0] = head;
    change[1] = tail;
    System.arraycopy(item, head, change, 2, item.length - head - tail);
    return change;
  }

  private static boolean isMoved(int[] from, int[] item) {
    int first = item[0] < COORDINATES.length ? COORDINATES[item[0]] : 0;
    if (first == 0 || first >= item.length || from[0] != item[0] || from.length != item.length) {
      return false;
    }
    if (!Arrays.equals(from, 2, first, item, 2, first)) {
      return false;
    }
    for (int i = first; i < item.length; i++) {
      int even = first + (i - first) % 2;
      if (item[i] - from[i] != item[even] - from[even]) {
        return false;
      }
    }
    return true;
  }

  private static int[] moved(int[] from, int[] item) {
    int first = COORDINATES[item[0]];
    return new int[] {-1, item[1], item[first] - from[first], item[first + 1] - from[first + 1]};
  }
}

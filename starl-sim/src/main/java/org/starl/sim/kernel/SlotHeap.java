package org.starl.sim.kernel;

import java.util.Arrays;

/**
 * A binary heap of slots, ordered by time and then by insertion. Each slot's {@code place} is its
 * heap index combined with the heap's mark, so that any event can be removed.
 */
final class SlotHeap {

  /** The mark of the second heap; every index is less. */
  static final int MARK_BIT = 1 << 30;

  private static final int INITIAL_SIZE = 16;

  private final EventTable events;
  private final int mark;
  private int[] slots = new int[INITIAL_SIZE];
  private long[] times = new long[INITIAL_SIZE];
  private long[] orders = new long[INITIAL_SIZE];
  private int size;
  private long lastOrder;

  /**
   * @param mark 0 or {@link #MARK_BIT}
   */
  SlotHeap(EventTable events, int mark) {
    this.events = events;
    this.mark = mark;
  }

  boolean isEmpty() {
    return size == 0;
  }

  /** The earliest slot, or {@link EventTable#NONE}. */
  int first() {
    return size == 0 ? EventTable.NONE : slots[0];
  }

  /** The time of the earliest slot, or {@link Long#MAX_VALUE} if the heap is empty. */
  long firstAtNs() {
    return size == 0 ? Long.MAX_VALUE : times[0];
  }

  void add(int slot, long atNs) {
    if (size == slots.length) {
      slots = Arrays.copyOf(slots, 2 * size);
      times = Arrays.copyOf(times, 2 * size);
      orders = Arrays.copyOf(orders, 2 * size);
    }
    siftUp(size++, slot, atNs, ++lastOrder);
  }

  void removeFirst() {
    remove(mark);
  }

  /**
   * Removes a slot.
   *
   * @param place the slot's place
   */
  void remove(int place) {
    int index = place - mark;
    size--;
    if (index == size) {
      return;
    }
    int slot = slots[size];
    long atNs = times[size];
    long order = orders[size];
    if (index > 0 && isBefore(atNs, order, (index - 1) >>> 1)) {
      siftUp(index, slot, atNs, order);
    } else {
      siftDown(index, slot, atNs, order);
    }
  }

  private void siftUp(int from, int slot, long atNs, long order) {
    int index = from;
    while (index > 0) {
      int parent = (index - 1) >>> 1;
      if (!isBefore(atNs, order, parent)) {
        break;
      }
      put(index, slots[parent], times[parent], orders[parent]);
      index = parent;
    }
    put(index, slot, atNs, order);
  }

  private void siftDown(int from, int slot, long atNs, long order) {
    int index = from;
    for (int child = 2 * index + 1; child < size; child = 2 * index + 1) {
      if (child + 1 < size && isBefore(times[child + 1], orders[child + 1], child)) {
        child++;
      }
      if (isBefore(atNs, order, child)) {
        break;
      }
      put(index, slots[child], times[child], orders[child]);
      index = child;
    }
    put(index, slot, atNs, order);
  }

  /** The total order of events. */
  private boolean isBefore(long atNs, long order, int index) {
    return atNs < times[index] || (atNs == times[index] && order < orders[index]);
  }

  private void put(int index, int slot, long atNs, long order) {
    slots[index] = slot;
    times[index] = atNs;
    orders[index] = order;
    events.setPlace(slot, mark + index);
  }
}

package org.starl.sim.kernel;

import java.util.Arrays;

/**
 * A binary heap of slots in the order of events. Each slot's {@code place} is its index here, so
 * that any event can be removed.
 */
final class SlotHeap {

  private final EventTable events;
  private int[] slots = new int[16];
  private int size;

  SlotHeap(EventTable events) {
    this.events = events;
  }

  boolean isEmpty() {
    return size == 0;
  }

  /** The earliest slot, or {@link EventTable#NONE}. */
  int first() {
    return size == 0 ? EventTable.NONE : slots[0];
  }

  void add(int slot) {
    if (size == slots.length) {
      slots = Arrays.copyOf(slots, 2 * size);
    }
    siftUp(size++, slot);
  }

  void removeAt(int index) {
    int last = slots[--size];
    if (index == size) {
      return;
    }
    if (index > 0 && events.isBefore(last, slots[(index - 1) >>> 1])) {
      siftUp(index, last);
    } else {
      siftDown(index, last);
    }
  }

  private void siftUp(int from, int slot) {
    int index = from;
    while (index > 0) {
      int parent = (index - 1) >>> 1;
      if (!events.isBefore(slot, slots[parent])) {
        break;
      }
      put(index, slots[parent]);
      index = parent;
    }
    put(index, slot);
  }

  private void siftDown(int from, int slot) {
    int index = from;
    for (int child = 2 * index + 1; child < size; child = 2 * index + 1) {
      if (child + 1 < size && events.isBefore(slots[child + 1], slots[child])) {
        child++;
      }
      if (!events.isBefore(slots[child], slot)) {
        break;
      }
      put(index, slots[child]);
      index = child;
    }
    put(index, slot);
  }

  private void put(int index, int slot) {
    slots[index] = slot;
    events.setPlace(slot, index);
  }
}

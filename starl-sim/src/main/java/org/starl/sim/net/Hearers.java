package org.starl.sim.net;

import java.util.Arrays;

/** The robots that hear a broadcast, by number; filled again for each broadcast. */
public final class Hearers {

  private int[] numbers = new int[16];
  private int size;

  /** Adds a robot that is not among them. */
  public void add(int number) {
    if (size == numbers.length) {
      numbers = Arrays.copyOf(numbers, 2 * size);
    }
    numbers[size] = number;
    size++;
  }

  void clear() {
    size = 0;
  }

  /** Sorts them, so that their order does not depend on how they were found. */
  void sort() {
    Arrays.sort(numbers, 0, size);
  }

  int size() {
    return size;
  }

  int number(int index) {
    return numbers[index];
  }
}

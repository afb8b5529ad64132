package org.starl.cli;

import java.util.concurrent.atomic.AtomicReferenceArray;
import org.jspecify.annotations.Nullable;

/** A value for each run of a campaign. Runs end on several threads, in any order. */
final class BySeed<T> {

  private final long first;
  private final AtomicReferenceArray<@Nullable T> values;

  BySeed(Seeds.Range range) {
    first = range.first();
    values = new AtomicReferenceArray<>((int) (range.last() - first + 1));
  }

  void put(long seed, T value) {
    values.set((int) (seed - first), value);
  }

  /** The value of a run, or null if it has none. */
  @Nullable T get(long seed) {
    return values.get((int) (seed - first));
  }
}

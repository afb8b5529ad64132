package org.starl.cli;

import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Measures;

/** What each run of a campaign measured; runs may end on several threads, in any order. */
final class Samples {

  private final long first;
  private final AtomicReferenceArray<@Nullable Measures> bySeed;

  Samples(Seeds.Range range) {
    first = range.first();
    bySeed = new AtomicReferenceArray<>((int) (range.last() - range.first() + 1));
  }

  void put(long seed, Measures measures) {
    bySeed.set((int) (seed - first), measures);
  }

  /** Robots that did what they came for. */
  long completed() {
    return measures().map(i -> get(i).completed()).sum();
  }

  /** Whatever else was counted, over all runs. */
  SortedMap<String, Long> counts() {
    SortedMap<String, Long> sums = new TreeMap<>();
    measures()
        .forEach(i -> get(i).counts().forEach((what, count) -> sums.merge(what, count, Long::sum)));
    return sums;
  }

  /** No more than so many percent of all waits are shorter; 0 if nobody waited. */
  long waitNs(int percent) {
    long[] waits =
        measures()
            .flatMap(i -> get(i).waitsNs().stream().mapToLong(Long::longValue))
            .sorted()
            .toArray();
    return Measures.waitNs(waits, percent);
  }

  private LongStream measures() {
    return LongStream.range(0, bySeed.length()).filter(i -> bySeed.get((int) i) != null);
  }

  private Measures get(long index) {
    return Objects.requireNonNull(bySeed.get((int) index));
  }
}

package org.starl.cli.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The parts of the theories and protocols that few runs of a campaign reached, and seeds of such runs. A
 * part is an action of an automaton, a conjunct that was false, or a type of message that was
 * delivered in a phase and a location.
 */
public final class RareParts {

  /** A rare part is reached by less than one run in so many. */
  private static final int RARE = 3;

  private static final int MOST_PARTS = 10;
  private static final int MOST_SEEDS = 8;

  private final SortedMap<String, Part> parts = new TreeMap<>();
  private long runs;

  private static final class Part {
    private final List<Long> seeds = new ArrayList<>();
    private long runs;
  }

  /** Adds the next run. */
  public void add(long seed, Coverage coverage) {
    runs++;
    for (String name : coverage.parts().names()) {
      Part part = parts.computeIfAbsent(name, any -> new Part());
      part.runs++;
      if (part.seeds.size() < MOST_SEEDS) {
        part.seeds.add(seed);
      }
    }
  }

  /**
   * Seeds of runs that reached the rarest parts, each part in turn.
   *
   * @param count how many seeds; one may occur several times
   * @return none if no part is rare
   */
  public List<Long> seeds(int count) {
    List<Part> rare =
        parts.values().stream()
            .filter(part -> part.runs * RARE < runs)
            .sorted(Comparator.comparingLong(part -> part.runs))
            .limit(MOST_PARTS)
            .toList();
    List<Long> seeds = new ArrayList<>();
    for (int i = 0; i < count && !rare.isEmpty(); i++) {
      List<Long> some = rare.get(i % rare.size()).seeds;
      seeds.add(some.get(i / rare.size() % some.size()));
    }
    return seeds;
  }
}

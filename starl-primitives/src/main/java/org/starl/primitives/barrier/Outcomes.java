package org.starl.primitives.barrier;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;

/**
 * The outcomes of all generations up to some number: those in {@code missing} failed, all others were
 * passed. So a robot that has skipped numbers misses no outcome.
 *
 * @param missing the members excluded by each failed generation; none twice, so this stays short
 */
record Outcomes(SortedMap<Long, SortedSet<ProcessId>> missing) {

  static final Outcomes ALL_PASSED = new Outcomes(new TreeMap<>());

  Outcomes {
    SortedMap<Long, SortedSet<ProcessId>> copy = new TreeMap<>();
    missing.forEach((generation, ids) ->
        copy.put(generation, Collections.unmodifiableSortedSet(new TreeSet<>(ids))));
    missing = Collections.unmodifiableSortedMap(copy);
  }

  /** With one more failed generation. */
  Outcomes withBroken(long generation, Collection<ProcessId> ids) {
    SortedMap<Long, SortedSet<ProcessId>> more = new TreeMap<>(missing);
    more.put(generation, new TreeSet<>(ids));
    return new Outcomes(more);
  }

  boolean isBroken(long generation) {
    return missing.containsKey(generation);
  }

  /** The members excluded by {@code generation}, which must have failed. */
  SortedSet<ProcessId> missing(long generation) {
    SortedSet<ProcessId> ids = missing.get(generation);
    if (ids == null) {
      throw new IllegalArgumentException("generation " + generation + " has not failed");
    }
    return ids;
  }

  /** The members of {@code generation}: the initial members minus those excluded earlier. */
  SortedSet<ProcessId> members(SortedSet<ProcessId> first, long generation) {
    TreeSet<ProcessId> members = new TreeSet<>(first);
    missing.headMap(generation).values().forEach(members::removeAll);
    return members;
  }

  /** The generation that excluded {@code id}; 0 if none did. */
  long leftOutBy(ProcessId id) {
    for (var entry : missing.entrySet()) {
      if (entry.getValue().contains(id)) {
        return entry.getKey();
      }
    }
    return 0;
  }
}

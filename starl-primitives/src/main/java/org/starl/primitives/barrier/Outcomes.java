package org.starl.primitives.barrier;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;

/**
 * The outcomes of all generations up to some number: those that are named here were broken by the
 * absence of some, and all others were passed. Whoever has skipped numbers needs no others.
 *
 * @param missing who was left out by each broken generation; nobody twice, so this stays short
 */
record Outcomes(SortedMap<Long, SortedSet<ProcessId>> missing) {

  static final Outcomes ALL_PASSED = new Outcomes(new TreeMap<>());

  Outcomes {
    SortedMap<Long, SortedSet<ProcessId>> copy = new TreeMap<>();
    missing.forEach((generation, ids) ->
        copy.put(generation, Collections.unmodifiableSortedSet(new TreeSet<>(ids))));
    missing = Collections.unmodifiableSortedMap(copy);
  }

  /** These, and one more generation that was broken. */
  Outcomes withBroken(long generation, Collection<ProcessId> ids) {
    SortedMap<Long, SortedSet<ProcessId>> more = new TreeMap<>(missing);
    more.put(generation, new TreeSet<>(ids));
    return new Outcomes(more);
  }

  boolean isBroken(long generation) {
    return missing.containsKey(generation);
  }

  /** Who was left out by {@code generation}, which must be broken. */
  SortedSet<ProcessId> missing(long generation) {
    SortedSet<ProcessId> ids = missing.get(generation);
    if (ids == null) {
      throw new IllegalArgumentException("generation " + generation + " is not broken");
    }
    return ids;
  }

  /** The members of {@code generation}: those of the first without whom those before left out. */
  SortedSet<ProcessId> members(SortedSet<ProcessId> first, long generation) {
    TreeSet<ProcessId> members = new TreeSet<>(first);
    missing.headMap(generation).values().forEach(members::removeAll);
    return members;
  }

  /** Which generation left {@code id} out; 0 if none did. */
  long leftOutBy(ProcessId id) {
    for (var entry : missing.entrySet()) {
      if (entry.getValue().contains(id)) {
        return entry.getKey();
      }
    }
    return 0;
  }
}

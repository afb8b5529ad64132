package org.starl.id;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** An immutable set of robots, sorted by name. */
public final class Participants implements Iterable<RobotId> {

  private final List<RobotId> ids;

  // Created on first use: most sets are never searched. Two threads may both create it; the results
  // are equal and immutable.
  private @Nullable Names names;

  private Participants(Collection<RobotId> ids) {
    this.ids = List.copyOf(new ArrayList<>(new TreeSet<>(ids)));
  }

  public static Participants of(RobotId... ids) {
    return new Participants(List.of(ids));
  }

  public static Participants of(Collection<RobotId> ids) {
    return new Participants(ids);
  }

  public boolean contains(RobotId id) {
    return indexOf(id) >= 0;
  }

  /** The place of a robot in {@link #asList}; negative if it is not in the set. */
  int indexOf(RobotId id) {
    return Collections.binarySearch(ids, id);
  }

  /** The robot whose name in ASCII is these bytes, or null if it is not in the set. */
  public @Nullable RobotId find(byte[] bytes, int from, int length) {
    Names found = names;
    if (found == null) {
      found = new Names(ids);
      names = found;
    }
    return found.find(bytes, from, length);
  }

  public int size() {
    return ids.size();
  }

  /** The robots in order. */
  public List<RobotId> asList() {
    return ids;
  }

  @Override
  public Iterator<RobotId> iterator() {
    return ids.iterator();
  }

  @Override
  public boolean equals(Object other) {
    return this == other || (other instanceof Participants that && ids.equals(that.ids));
  }

  @Override
  public int hashCode() {
    return ids.hashCode();
  }

  @Override
  public String toString() {
    return ids.toString();
  }

  /**
   * A hash table with open addressing, at most two thirds full. All names are in one array: with
   * thousands of robots, their strings would not be in the cache.
   */
  private static final class Names {
    private static final int GOLDEN_RATIO = 0x9E3779B9;

    /** The robot in each slot, or null. */
    private final @Nullable RobotId[] ids;

    /**
     * The names in slot order: slot {@code i} has the bytes from {@code starts[i]} to {@code
     * starts[i + 1]}.
     */
    private final byte[] letters;

    private final int[] starts;

    Names(List<RobotId> robots) {
      ids = new RobotId[2 * Integer.highestOneBit(robots.size() + robots.size() / 2 + 1)];
      starts = new int[ids.length + 1];
      for (RobotId robot : robots) {
        int slot = slot(robot.hashCode());
        while (ids[slot] != null) {
          slot = (slot + 1) & (ids.length - 1);
        }
        ids[slot] = robot;
      }
      StringBuilder all = new StringBuilder();
      for (int slot = 0; slot < ids.length; slot++) {
        RobotId robot = ids[slot];
        all.append(robot == null ? "" : robot.name());
        starts[slot + 1] = all.length();
      }
      letters = all.toString().getBytes(StandardCharsets.US_ASCII);
    }

    @Nullable RobotId find(byte[] bytes, int from, int length) {
      int hash = 0;
      for (int i = from; i < from + length; i++) {
        hash = 31 * hash + bytes[i]; // as String.hashCode
      }
      int slot = slot(hash);
      while (starts[slot + 1] > starts[slot]) {
        if (isNamed(slot, bytes, from, length)) {
          return ids[slot];
        }
        slot = (slot + 1) & (ids.length - 1);
      }
      return null;
    }

    private boolean isNamed(int slot, byte[] bytes, int from, int length) {
      int start = starts[slot];
      if (starts[slot + 1] - start != length) {
        return false;
      }
      // Names differ in their last letters: compared from there, most comparisons end at once.
      for (int i = length - 1; i >= 0; i--) {
        if (letters[start + i] != bytes[from + i]) {
          return false;
        }
      }
      return true;
    }

    /**
     * Fibonacci hashing (Knuth, "The Art of Computer Programming", section 6.4): names that differ
     * only in their last digits have neighbouring hashes, which would form long runs of occupied
     * slots.
     */
    private int slot(int hash) {
      return (hash * GOLDEN_RATIO) >>> (Integer.numberOfLeadingZeros(ids.length) + 1);
    }
  }
}

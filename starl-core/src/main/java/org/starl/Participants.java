package org.starl;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** A set of robots in the order of their names. Immutable. */
public final class Participants implements Iterable<RobotId> {

  private final List<RobotId> ids;

  // Made when first asked for: most sets are never asked. Two threads may both make it, and get
  // equal ones: it is immutable.
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
    return ids.contains(id);
  }

  /** The robot whose name in ASCII these bytes are, or null if it is none of these. */
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
    return other instanceof Participants that && ids.equals(that.ids);
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
   * A hash table with open addressing, at most half full, over all names in one array: with thousands
   * of robots their own strings would be cold.
   */
  private static final class Names {
    private static final int GOLDEN_RATIO = 0x9E3779B9;

    private final RobotId[] ids;

    /** All names, one after another; each from {@code starts[i]} to {@code starts[i + 1]}. */
    private final byte[] letters;

    private final int[] starts;

    /** Index and 1 of the robot in each slot, 0 in an empty one. */
    private final int[] slots;

    Names(List<RobotId> robots) {
      ids = robots.toArray(new RobotId[0]);
      starts = new int[ids.length + 1];
      StringBuilder all = new StringBuilder();
      slots = new int[Integer.highestOneBit(2 * ids.length + 1) * 2];
      for (int i = 0; i < ids.length; i++) {
        all.append(ids[i].name());
        starts[i + 1] = all.length();
        int slot = slot(ids[i].hashCode());
        while (slots[slot] != 0) {
          slot = (slot + 1) & (slots.length - 1);
        }
        slots[slot] = i + 1;
      }
      letters = all.toString().getBytes(StandardCharsets.US_ASCII);
    }

    @Nullable RobotId find(byte[] bytes, int from, int length) {
      int hash = 0;
      for (int i = from; i < from + length; i++) {
        hash = 31 * hash + bytes[i]; // as a name's
      }
      int slot = slot(hash);
      while (slots[slot] != 0) {
        int robot = slots[slot] - 1;
        if (isNamed(robot, bytes, from, length)) {
          return ids[robot];
        }
        slot = (slot + 1) & (slots.length - 1);
      }
      return null;
    }

    private boolean isNamed(int robot, byte[] bytes, int from, int length) {
      int start = starts[robot];
      if (starts[robot + 1] - start != length) {
        return false;
      }
      // Names differ in their last letters: from there, most comparisons end at once.
      for (int i = length - 1; i >= 0; i--) {
        if (letters[start + i] != bytes[from + i]) {
          return false;
        }
      }
      return true;
    }

    /**
     * Fibonacci hashing (Knuth, "The Art of Computer Programming", section 6.4): names that differ in
     * their last digits have neighbouring hashes, which would fill long runs of slots.
     */
    private int slot(int hash) {
      return (hash * GOLDEN_RATIO) >>> (Integer.numberOfLeadingZeros(slots.length) + 1);
    }
  }
}

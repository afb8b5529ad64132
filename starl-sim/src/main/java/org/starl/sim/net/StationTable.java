package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.kernel.SimStrand;

/**
 * The network's data of each robot that ever had a radio: a hash table with open addressing, at
 * most two thirds full, without removal. The data that a sender needs of a recipient is stored in
 * the table itself: with thousands of robots, all other data of the recipient is outside the cache.
 */
final class StationTable {

  /** No slot. */
  static final int NONE = -1;

  private static final int GOLDEN_RATIO = 0x9E3779B9;
  private static final int LEAST_SLOTS = 16;

  // Indexed by slot; null for a free slot.
  private @Nullable RobotId[] ids = new RobotId[LEAST_SLOTS];
  private long[] keys = new long[LEAST_SLOTS];
  private @Nullable SimRadio[] radios = new SimRadio[LEAST_SLOTS];
  private @Nullable SimStrand[] strands = new SimStrand[LEAST_SLOTS];
  private long[] datagrams = new long[LEAST_SLOTS];
  private int[] numbers = new int[LEAST_SLOTS];
  private int size;

  /** The robot's slot, valid until another robot is added; or {@link #NONE}. */
  int slot(RobotId id) {
    int slot = firstSlot(id);
    RobotId found = ids[slot];
    while (found != null && !found.equals(id)) {
      slot = (slot + 1) & (ids.length - 1);
      found = ids[slot];
    }
    return found == null ? NONE : slot;
  }

  /** Adds a robot that is not in the table, and returns its slot. */
  int add(RobotId id, long key) {
    int number = size;
    size++;
    if (3 * size > 2 * ids.length) {
      grow();
    }
    int slot = freeSlot(id);
    ids[slot] = id;
    keys[slot] = key;
    numbers[slot] = number;
    return slot;
  }

  /** Sets the robot's radio and strand. */
  void attach(int slot, SimRadio radio, SimStrand strand) {
    radios[slot] = radio;
    strands[slot] = strand;
  }

  /** Removes the robot's radio. */
  void detach(int slot, long datagramsSent) {
    datagrams[slot] = datagramsSent;
    radios[slot] = null;
    strands[slot] = null;
  }

  /** The number of robots that were added before this one; {@link #NONE} for {@link #NONE}. */
  int number(int slot) {
    return slot == NONE ? NONE : numbers[slot];
  }

  /** The key of the robot's random numbers. */
  long key(int slot) {
    return keys[slot];
  }

  /** The robot's radio, or null; null for {@link #NONE}. */
  @Nullable SimRadio radio(int slot) {
    return slot == NONE ? null : radios[slot];
  }

  /** The robot's strand, or null if it has no radio; null for {@link #NONE}. */
  @Nullable SimStrand strand(int slot) {
    return slot == NONE ? null : strands[slot];
  }

  /** The number of datagrams sent by the robot's earlier incarnations. */
  long datagrams(int slot) {
    return datagrams[slot];
  }

  private int freeSlot(RobotId id) {
    int slot = firstSlot(id);
    while (ids[slot] != null) {
      slot = (slot + 1) & (ids.length - 1);
    }
    return slot;
  }

  private void grow() {
    @Nullable RobotId[] oldIds = ids;
    long[] oldKeys = keys;
    @Nullable SimRadio[] oldRadios = radios;
    @Nullable SimStrand[] oldStrands = strands;
    long[] oldDatagrams = datagrams;
    int[] oldNumbers = numbers;
    int slots = 2 * oldIds.length;
    ids = new RobotId[slots];
    keys = new long[slots];
    radios = new SimRadio[slots];
    strands = new SimStrand[slots];
    datagrams = new long[slots];
    numbers = new int[slots];
    for (int old = 0; old < oldIds.length; old++) {
      RobotId id = oldIds[old];
      if (id != null) {
        int slot = freeSlot(id);
        ids[slot] = id;
        keys[slot] = oldKeys[old];
        radios[slot] = oldRadios[old];
        strands[slot] = oldStrands[old];
        datagrams[slot] = oldDatagrams[old];
        numbers[slot] = oldNumbers[old];
      }
    }
  }

  // Fibonacci hashing (Knuth, "The Art of Computer Programming", section 6.4): numbered names have
  // adjacent hashes.
  private int firstSlot(RobotId id) {
    return (id.hashCode() * GOLDEN_RATIO) >>> (Integer.numberOfLeadingZeros(ids.length) + 1);
  }
}

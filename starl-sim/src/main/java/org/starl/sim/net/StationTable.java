package org.starl.sim.net;

import org.jspecify.annotations.Nullable;
import org.starl.RobotId;

/**
 * The stations by their robots: a hash table with open addressing, at most half full, from which
 * nothing is removed. A look-up touches a slot and the station itself.
 */
final class StationTable {

  private static final int GOLDEN_RATIO = 0x9E3779B9;

  private SimNetwork.@Nullable Station[] slots = table(16);
  private int size;

  SimNetwork.@Nullable Station find(RobotId id) {
    int slot = slot(id);
    SimNetwork.Station station = slots[slot];
    while (station != null && !station.id().equals(id)) {
      slot = (slot + 1) & (slots.length - 1);
      station = slots[slot];
    }
    return station;
  }

  /** Adds the station of a robot that has none here. */
  void add(SimNetwork.Station station) {
    if (2 * (size + 1) > slots.length) {
      SimNetwork.@Nullable Station[] old = slots;
      slots = table(2 * old.length);
      for (SimNetwork.Station moved : old) {
        if (moved != null) {
          insert(moved);
        }
      }
    }
    insert(station);
    size++;
  }

  private void insert(SimNetwork.Station station) {
    int slot = slot(station.id());
    while (slots[slot] != null) {
      slot = (slot + 1) & (slots.length - 1);
    }
    slots[slot] = station;
  }

  // Fibonacci hashing (Knuth, "The Art of Computer Programming", section 6.4): numbered names have
  // neighbouring hashes.
  private int slot(RobotId id) {
    return (id.hashCode() * GOLDEN_RATIO) >>> (Integer.numberOfLeadingZeros(slots.length) + 1);
  }

  private static SimNetwork.@Nullable Station[] table(int length) {
    return new SimNetwork.Station[length];
  }
}

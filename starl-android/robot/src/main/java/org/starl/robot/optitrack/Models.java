package org.starl.robot.optitrack;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** The names of a server's rigid bodies, by their numbers in its frames. */
final class Models {

  /** Before a server has sent its descriptions. */
  static final Models NONE = new Models(new LinkedHashMap<>(), true);

  private final Map<Integer, String> names;
  private final TreeSet<String> ambiguous = new TreeSet<>();
  private final boolean isWhole;

  private Models(Map<Integer, String> names, boolean isWhole) {
    this.names = names;
    this.isWhole = isWhole;
    Set<String> distinct = new TreeSet<>();
    for (String name : names.values()) {
      if (!distinct.add(name)) {
        ambiguous.add(name);
      }
    }
  }

  /** The name of body {@code id}, or null if there is none. */
  @Nullable String name(int id) {
    return names.get(id);
  }

  Set<Integer> ids() {
    return names.keySet();
  }

  /** The numbers that have another name, or none, in {@code other}. */
  Set<Integer> differences(Models other) {
    Set<Integer> different = new TreeSet<>(names.keySet());
    different.addAll(other.names.keySet());
    different.removeIf(id -> Objects.equals(names.get(id), other.names.get(id)));
    return different;
  }

  boolean has(String name) {
    return names.containsValue(name);
  }

  /** Whether two bodies have this name, so that it identifies neither. */
  boolean isAmbiguous(String name) {
    return ambiguous.contains(name);
  }

  /** Whether every description could be read. */
  boolean isWhole() {
    return isWhole;
  }

  @Override
  public String toString() {
    return names.values().toString();
  }

  /**
   * The bodies described in the payload {@code in}. From 4.1 on unknown descriptions are skipped by
   * their size; before, the first unknown description ends the list.
   */
  static Models parse(LittleEndianReader in, NatNetVersion version) {
    Map<Integer, String> names = new LinkedHashMap<>();
    boolean isWhole = true;
    int typeBytes = 4;
    int count = in.count(typeBytes);
    for (int i = 0; i < count && isWhole; i++) {
      int type = in.i32();
      if (version.tellsSizes()) {
        LittleEndianReader description = in.section(in.i32());
        if (type == Description.RIGID_BODY) {
          String name = description.name();
          names.put(description.i32(), name);
        }
      } else if (type == Description.RIGID_BODY) {
        String name = in.name();
        int id = in.i32();
        Description.skipRestOfBody(in, version);
        names.put(id, name);
      } else {
        isWhole = Description.skip(in, type, version);
      }
    }
    return new Models(names, isWhole);
  }
}

package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.RobotId;

/** The robots heard of late, found by the bytes of their names without building strings. */
final class RobotNames {

  /** Of two names with equal low bits of their hash the later one stays. */
  private static final int SLOTS = 32;

  private final @Nullable Entry[] entries;

  RobotNames() {
    entries = new Entry[SLOTS];
  }

  /** The robot, or null if these bytes are no robot's name. */
  @Nullable RobotId find(byte[] bytes, int from, int length) {
    int slot = ByteNames.hash(bytes, from, length) & (SLOTS - 1);
    Entry entry = entries[slot];
    if (entry != null && ByteNames.equal(entry.name, bytes, from, length)) {
      return entry.id;
    }
    if (!WireReader.isAscii(bytes, from, length)) {
      return null;
    }
    String text = new String(bytes, from, length, StandardCharsets.ISO_8859_1);
    if (!RobotId.isValid(text)) {
      return null;
    }
    RobotId id = new RobotId(text);
    entries[slot] = new Entry(Arrays.copyOfRange(bytes, from, from + length), id);
    return id;
  }

  private static final class Entry {
    private final byte[] name;
    private final RobotId id;

    Entry(byte[] name, RobotId id) {
      this.name = name;
      this.id = id;
    }
  }
}

package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * Robots that were heard of late and are none of the deployment, found by the bytes of their names
 * without building strings.
 */
final class Strangers {

  /** Of two strangers with equal low bits of their hash the later one stays. */
  private static final int SLOTS = 32;

  private final @Nullable Stranger[] slots = new Stranger[SLOTS];

  /** The robot, or null if these bytes are no robot's name. */
  @Nullable RobotId find(byte[] bytes, int from, int length) {
    int slot = ByteNames.hash(bytes, from, length) & (SLOTS - 1);
    Stranger stranger = slots[slot];
    if (stranger == null || !ByteNames.equal(stranger.letters, bytes, from, length)) {
      String name = new String(bytes, from, length, StandardCharsets.ISO_8859_1);
      if (!RobotId.isValid(name)) {
        return null;
      }
      stranger = new Stranger(Arrays.copyOfRange(bytes, from, from + length), new RobotId(name));
      slots[slot] = stranger;
    }
    return stranger.id;
  }

  private static final class Stranger {
    private final byte[] letters;
    private final RobotId id;

    Stranger(byte[] letters, RobotId id) {
      this.letters = letters;
      this.id = id;
    }
  }
}

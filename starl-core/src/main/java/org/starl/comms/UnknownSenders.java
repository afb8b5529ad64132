package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * Recently received names of robots that are not in the deployment, found by the bytes of the name
 * without creating strings.
 */
final class UnknownSenders {

  /** Two robots with equal low bits of their hash share a slot; the later one stays. */
  private static final int SLOTS = 32;

  private final @Nullable Sender[] slots = new Sender[SLOTS];

  /** The robot of this name, or null if the bytes are not a valid robot name. */
  @Nullable RobotId find(byte[] bytes, int from, int length) {
    int slot = ByteNames.hash(bytes, from, length) & (SLOTS - 1);
    Sender sender = slots[slot];
    if (sender == null || !ByteNames.equal(sender.letters, bytes, from, length)) {
      String name = new String(bytes, from, length, StandardCharsets.ISO_8859_1);
      if (!RobotId.isValid(name)) {
        return null;
      }
      sender = new Sender(Arrays.copyOfRange(bytes, from, from + length), new RobotId(name));
      slots[slot] = sender;
    }
    return sender.id;
  }

  private static final class Sender {
    private final byte[] letters;
    private final RobotId id;

    Sender(byte[] letters, RobotId id) {
      this.letters = letters;
      this.id = id;
    }
  }
}

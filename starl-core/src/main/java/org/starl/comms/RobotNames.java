package org.starl.comms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.Participants;
import org.starl.RobotId;

/**
 * The robots that send to this one, found by the bytes of their names without building strings: those
 * of the deployment, and strangers that were heard of late.
 */
final class RobotNames {

  /** Of two strangers with equal low bits of their hash the later one stays. */
  private static final int SLOTS = 32;

  private final Participants deployment;
  private @Nullable Stranger @Nullable [] strangers;

  RobotNames(Participants deployment) {
    this.deployment = deployment;
  }

  /** The robot, or null if these bytes are no robot's name. */
  @Nullable RobotId find(byte[] bytes, int from, int length) {
    RobotId known = deployment.find(bytes, from, length);
    return known != null ? known : stranger(bytes, from, length);
  }

  private @Nullable RobotId stranger(byte[] bytes, int from, int length) {
    if (strangers == null) {
      strangers = new Stranger[SLOTS];
    }
    int slot = ByteNames.hash(bytes, from, length) & (SLOTS - 1);
    Stranger stranger = strangers[slot];
    if (stranger == null || !ByteNames.equal(stranger.letters, bytes, from, length)) {
      String name = new String(bytes, from, length, StandardCharsets.ISO_8859_1);
      if (!RobotId.isValid(name)) {
        return null;
      }
      stranger = new Stranger(Arrays.copyOfRange(bytes, from, from + length), new RobotId(name));
      strangers[slot] = stranger;
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

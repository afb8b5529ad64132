package org.starl.comms;

import java.nio.charset.StandardCharsets;
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
  private @Nullable RobotId @Nullable [] strangers;

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
      strangers = new RobotId[SLOTS];
    }
    int slot = ByteNames.hash(bytes, from, length) & (SLOTS - 1);
    RobotId stranger = strangers[slot];
    if (stranger != null && stranger.isNamed(bytes, from, length)) {
      return stranger;
    }
    String name = new String(bytes, from, length, StandardCharsets.ISO_8859_1);
    if (!RobotId.isValid(name)) {
      return null;
    }
    RobotId id = new RobotId(name);
    strangers[slot] = id;
    return id;
  }
}

package org.starl.comms;

import java.util.Arrays;
import javax.crypto.Mac;
import javax.crypto.ShortBufferException;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;

/**
 * Authenticates datagrams as sent by a robot of the deployment: appends a count of this robot's
 * transmissions, and the first half of HMAC-SHA256 (RFC 2104; truncated as its section 5 allows)
 * over everything before. Strand only.
 */
final class Seal {

  private static final int TAG_BYTES = 16;

  /** Number of bytes that authentication adds. */
  static final int BYTES = Long.BYTES + TAG_BYTES;

  private final ReplayWindows replays = new ReplayWindows();
  private final Mac mac;
  private final byte[] code;
  private byte[] sealed = new byte[128];
  private long transmissions;

  Seal(DeploymentKey key) {
    mac = key.newMac();
    code = new byte[mac.getMacLength()];
  }

  /** The last sealed datagram; valid until the next one. */
  byte[] buffer() {
    return sealed;
  }

  /**
   * Copies a datagram and appends its authentication, with a new count even if it was sent before.
   *
   * @return the sealed datagram's length in bytes
   */
  int seal(byte[] datagram, int length) {
    if (sealed.length < length + BYTES) {
      sealed = new byte[length + BYTES];
    }
    System.arraycopy(datagram, 0, sealed, 0, length);
    transmissions++;
    WireWriter.putI64(sealed, length, transmissions);
    compute(sealed, length + Long.BYTES);
    System.arraycopy(code, 0, sealed, length + Long.BYTES, TAG_BYTES);
    return length + BYTES;
  }

  /**
   * Checks that a holder of the key sealed these bytes. Takes the same time wherever they differ.
   *
   * @return whether the authentication is correct
   */
  boolean verify(byte[] datagram, int length) {
    if (length < BYTES) {
      return false;
    }
    compute(datagram, length - TAG_BYTES);
    int difference = 0;
    for (int i = 0; i < TAG_BYTES; i++) {
      difference |= code[i] ^ datagram[length - TAG_BYTES + i];
    }
    return difference == 0;
  }

  /**
   * Accepts an authenticated datagram.
   *
   * @return why to drop it, or null if it arrives for the first time
   */
  @Nullable DropReason admit(RobotId from, int boot, long count) {
    return replays.admit(from, boot, count);
  }

  /** The transmission count of an authenticated datagram, from 1. */
  static long count(byte[] datagram, int length) {
    return WireReader.getI64(datagram, length - BYTES);
  }

  private void compute(byte[] bytes, int length) {
    try {
      mac.update(bytes, 0, length);
      mac.doFinal(code, 0);
    } catch (ShortBufferException e) {
      throw new IllegalStateException("a code of " + Arrays.toString(code), e);
    }
  }
}

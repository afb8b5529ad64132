package org.starl.robot.optitrack;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import javax.crypto.Mac;
import org.starl.platform.DeploymentKey;

/**
 * Authenticates the lines of the JSON feed: behind each line stand a space and the 64 hexadecimal
 * digits of its HMAC-SHA256 under the feed's key. One thread at a time.
 */
final class JsonSeal {

  /** Number of bytes that authentication adds. */
  static final int BYTES = 1 + 2 * DeploymentKey.BYTES;

  private static final int RADIX = 16;

  private final Mac mac;

  JsonSeal(DeploymentKey key) {
    mac = key.newMac("lines");
  }

  /** The line with its authentication. */
  byte[] seal(byte[] line) {
    byte[] sealed = Arrays.copyOf(line, line.length + BYTES);
    System.arraycopy(code(line, line.length), 0, sealed, line.length, BYTES);
    return sealed;
  }

  /** The length of the line in these bytes; -1 if they are not authenticated with the key. */
  int lineLength(byte[] bytes, int length) {
    int lineLength = length - BYTES;
    // No reader accepts a longer line; computing its code would only cost time.
    if (lineLength < 0 || lineLength > JsonPoseParser.MAX_BYTES) {
      return -1;
    }
    byte[] code = Arrays.copyOfRange(bytes, lineLength, length);
    return MessageDigest.isEqual(code(bytes, lineLength), code) ? lineLength : -1;
  }

  private byte[] code(byte[] bytes, int length) {
    mac.update(bytes, 0, length);
    StringBuilder digits = new StringBuilder(" ");
    for (byte b : mac.doFinal()) {
      digits
          .append(Character.forDigit(b >> 4 & 0xF, RADIX))
          .append(Character.forDigit(b & 0xF, RADIX));
    }
    return digits.toString().getBytes(StandardCharsets.US_ASCII);
  }
}

package org.starl.platform;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import javax.crypto.Mac;
import org.starl.id.RobotId;
import org.starl.session.PairKey;

/**
 * The secret that all robots of one deployment share; holding it proves membership. It is never
 * printed and cannot be read back. Immutable.
 */
public final class DeploymentKey {

  /** Length of a key in bytes. */
  public static final int BYTES = PairKey.BYTES;

  private final PairKey root;

  /**
   * @throws IllegalArgumentException if {@code secret} is not {@link #BYTES} long, or only zeros
   */
  public DeploymentKey(byte[] secret) {
    if (Arrays.equals(secret, new byte[BYTES])) {
      throw new IllegalArgumentException("a key of zeros: expected a random one");
    }
    root = new PairKey(secret);
  }

  /** Creates HMAC-SHA256 (RFC 2104) under this key for one purpose, for one thread. */
  public Mac newMac(String purpose) {
    return root.newMac(purpose);
  }

  /** The secret of two robots, in either order; equal if they are. */
  public PairKey pairKey(RobotId one, RobotId other) {
    boolean isInOrder = one.compareTo(other) <= 0;
    Mac mac = newMac("pair");
    mac.update(
        (isInOrder ? one + " " + other : other + " " + one).getBytes(StandardCharsets.US_ASCII));
    return new PairKey(mac.doFinal());
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof DeploymentKey that && root.equals(that.root);
  }

  @Override
  public int hashCode() {
    return root.hashCode();
  }

  @Override
  public String toString() {
    return "a deployment key";
  }
}

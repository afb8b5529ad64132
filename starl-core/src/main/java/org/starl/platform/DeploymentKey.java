package org.starl.platform;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * The secret that the robots of one deployment share: who has it is one of them. Never printed, and
 * without a way to read it back. Immutable.
 */
public final class DeploymentKey {

  /** Bytes of a key: as many as HMAC-SHA256 gives (RFC 2104, section 3). */
  public static final int BYTES = 32;

  private static final String ALGORITHM = "HmacSHA256";

  private final byte[] secret;

  /**
   * @throws IllegalArgumentException unless there are {@link #BYTES} of it
   */
  public DeploymentKey(byte[] secret) {
    if (secret.length != BYTES) {
      throw new IllegalArgumentException("a key of " + secret.length + " bytes: expected " + BYTES);
    }
    this.secret = secret.clone();
  }

  /** A generator of authentication codes under this key, for one strand. */
  public Mac newMac() {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(new SecretKeySpec(secret, ALGORITHM));
      return mac;
    } catch (GeneralSecurityException e) {
      // Every Java platform has it (java.security.Mac's documentation), and takes any key.
      throw new IllegalStateException(ALGORITHM, e);
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof DeploymentKey that && Arrays.equals(secret, that.secret);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(secret);
  }

  @Override
  public String toString() {
    return "a deployment key";
  }
}

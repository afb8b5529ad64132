package org.starl.platform;

import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * The secret that all robots of one deployment share; holding it proves membership. It is never
 * printed and cannot be read back. Immutable.
 */
public final class DeploymentKey {

  /** Length of a key: the output length of HMAC-SHA256 (RFC 2104, section 3). */
  public static final int BYTES = 32;

  private static final String ALGORITHM = "HmacSHA256";

  private final byte[] secret;

  /**
   * @throws IllegalArgumentException if {@code secret} is not {@link #BYTES} long
   */
  public DeploymentKey(byte[] secret) {
    if (secret.length != BYTES) {
      throw new IllegalArgumentException("a key of " + secret.length + " bytes: expected " + BYTES);
    }
    this.secret = secret.clone();
  }

  /** Creates a message authentication code with this key, for one strand. */
  public Mac newMac() {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(new SecretKeySpec(secret, ALGORITHM));
      return mac;
    } catch (GeneralSecurityException e) {
      // Every Java platform has HmacSHA256 (java.security.Mac) and accepts any key.
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

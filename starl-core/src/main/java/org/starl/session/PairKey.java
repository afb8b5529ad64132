package org.starl.session;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * The secret that two robots share, and the root of the keys of their sessions. With per-robot keys
 * no third robot has it; with one key for the whole deployment every robot can compute it. It is
 * never printed and cannot be read back. Immutable.
 */
public final class PairKey {

  /** Length of the secret in bytes. */
  public static final int BYTES = 32;

  private static final String ALGORITHM = "HmacSHA256";

  private final byte[] secret;
  private final int id;

  /**
   * @throws IllegalArgumentException if {@code secret} is not {@link #BYTES} long
   */
  public PairKey(byte[] secret) {
    if (secret.length != BYTES) {
      throw new IllegalArgumentException("a key of " + secret.length + " bytes: expected " + BYTES);
    }
    this.secret = secret.clone();
    this.id = ByteBuffer.wrap(derive("key id")).getInt();
  }

  /** A public number that tells it apart from earlier keys of the same robots. */
  public int id() {
    return id;
  }

  /** Creates a message authentication code for this purpose, for one thread. */
  public Mac newMac(String purpose) {
    return mac(derive(purpose));
  }

  /**
   * Derives a key: HMAC-SHA256 over the purpose and the context, as HKDF expands one block (RFC
   * 5869, section 2.3).
   */
  byte[] derive(String purpose, byte[]... context) {
    Mac mac = mac(secret);
    mac.update(("starl " + purpose).getBytes(StandardCharsets.US_ASCII));
    for (byte[] part : context) {
      // The length first: no two contexts give the same bytes.
      mac.update((byte) part.length);
      mac.update(part);
    }
    mac.update((byte) 1);
    return mac.doFinal();
  }

  private static Mac mac(byte[] key) {
    try {
      Mac mac = Mac.getInstance(ALGORITHM);
      mac.init(new SecretKeySpec(key, ALGORITHM));
      return mac;
    } catch (GeneralSecurityException e) {
      // Every Java platform has HmacSHA256 (java.security.Mac) and accepts any key.
      throw new IllegalStateException(ALGORITHM, e);
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof PairKey that && Arrays.equals(secret, that.secret);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(secret);
  }

  @Override
  public String toString() {
    return "a pair's key";
  }
}

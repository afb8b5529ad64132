package org.starl.session;

import java.nio.ByteBuffer;
import java.security.SecureRandom;

/** A random number of 128 bits that is used once: drawn at each start of a robot's program. */
public record Nonce(long high, long low) {

  public static final int BYTES = 2 * Long.BYTES;

  /** No nonce. Never drawn. */
  public static final Nonce NONE = new Nonce(0, 0);

  /** Draws a nonce that no other program can predict. */
  public static Nonce draw(SecureRandom random) {
    Nonce drawn;
    do {
      drawn = new Nonce(random.nextLong(), random.nextLong());
    } while (drawn.equals(NONE));
    return drawn;
  }

  /** Reads a nonce at the buffer's position. */
  public static Nonce read(ByteBuffer in) {
    return new Nonce(in.getLong(), in.getLong());
  }

  /** Writes it at the buffer's position. */
  public void write(ByteBuffer out) {
    out.putLong(high).putLong(low);
  }
}

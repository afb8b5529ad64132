package org.starl.session;

import java.nio.ByteBuffer;

/**
 * One start of a robot's program.
 *
 * @param epoch random number of the robot's stable storage, made with the storage
 * @param boot how often the program has started with that storage, from 1
 * @param nonce drawn at this start
 */
public record Start(long epoch, int boot, Nonce nonce) {

  public static final int BYTES = Long.BYTES + Integer.BYTES + Nonce.BYTES;

  /** Reads a start at the buffer's position. */
  public static Start read(ByteBuffer in) {
    return new Start(in.getLong(), in.getInt(), Nonce.read(in));
  }

  /** Writes it at the buffer's position. */
  public void write(ByteBuffer out) {
    out.putLong(epoch).putInt(boot);
    nonce.write(out);
  }
}

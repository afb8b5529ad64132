package org.starl.sim;

import java.nio.ByteBuffer;
import java.util.Set;
import java.util.TreeSet;
import org.starl.session.Session;

/**
 * Checks the seals of a run, from outside: it sees what is sealed and what comes out. A breach is a
 * bug of the code, not of the environment, so it ends the run.
 *
 * <p>AES-GCM adds a stream of bytes to the text; the key and the nonce decide the stream. Who sees
 * one stream twice learns the sum of two texts, and can forge datagrams (NIST SP 800-38D, section
 * 8). Two streams of different keys or nonces begin with the same 64 bits by chance only: among a
 * million datagrams with probability 3e-8.
 */
final class SealWatch implements Session.Watch {

  private final Set<Long> streams = new TreeSet<>();
  private byte[] opened = new byte[256];

  /**
   * @throws IllegalStateException if the sender used this key with this nonce before; or if the
   *     sender would take its own datagram, sent back to it, as one of the other robot
   */
  @Override
  public void sealed(Session session, byte[] datagram, int bodyAt, int length, byte[] sealed) {
    if (length - bodyAt >= Long.BYTES) { // a shorter body shows too little of the stream
      long text = ByteBuffer.wrap(datagram).getLong(bodyAt);
      long stream = text ^ ByteBuffer.wrap(sealed).getLong(bodyAt);
      if (!streams.add(stream)) {
        throw new IllegalStateException(
            "a key is used twice with one nonce: the datagram with count "
                + Session.count(sealed, length + Session.BYTES));
      }
    }
    if (opened.length < length) {
      opened = new byte[length];
    }
    if (session.open(sealed, bodyAt, length + Session.BYTES, opened)) {
      throw new IllegalStateException("a robot would accept its own datagram from another robot");
    }
  }
}

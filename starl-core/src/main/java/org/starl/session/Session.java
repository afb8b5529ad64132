package org.starl.session;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import javax.crypto.AEADBadTagException;
import javax.crypto.Cipher;
import javax.crypto.spec.GCMParameterSpec;
import javax.crypto.spec.SecretKeySpec;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * This robot's end of a session with one other robot: seals and opens datagrams with AES-256-GCM
 * (NIST SP 800-38D). A sealed datagram has its header in clear, its body encrypted, and after it
 * {@link #BYTES} more: a tag of 16, the session's id (4) and the count of this end's transmissions
 * (8, from 1). The tag covers all of them. The count is the nonce of GCM: it never repeats, since
 * each direction of each session has a key of its own. Strand only.
 */
public final class Session {

  private static final int TAG_BYTES = 16;
  private static final int IV_BYTES = 12;
  private static final int ID_BYTES = Integer.BYTES;

  /** Number of bytes that sealing adds. */
  public static final int BYTES = TAG_BYTES + ID_BYTES + Long.BYTES;

  private final int id;
  private final SecretKeySpec sendKey;
  private final SecretKeySpec receiveKey;
  private final Cipher cipher;
  private final byte[] iv = new byte[IV_BYTES];
  private final @Nullable Watch watch;
  private long transmissions;

  /** Is told of each datagram that a session seals, with its text in clear; for checks. */
  @FunctionalInterface
  public interface Watch {

    /**
     * Called on the session's strand. The buffers are valid during this call only.
     *
     * @param datagram in clear: a header of {@code bodyAt} bytes, a body up to {@code length}
     * @param sealed the same, sealed: {@code length + BYTES} bytes
     */
    void sealed(Session session, byte[] datagram, int bodyAt, int length, byte[] sealed);
  }

  /**
   * Opens this robot's end.
   *
   * @param key the secret of the two robots
   */
  public Session(PairKey key, RobotId self, Start mine, RobotId peer, Start theirs) {
    this(key, self, mine, peer, theirs, null);
  }

  Session(
      PairKey key, RobotId self, Start mine, RobotId peer, Start theirs, @Nullable Watch watch) {
    this.watch = watch;
    byte[] here = end(self, mine);
    byte[] there = end(peer, theirs);
    sendKey = new SecretKeySpec(key.derive("seal", here, there), "AES");
    receiveKey = new SecretKeySpec(key.derive("seal", there, here), "AES");
    boolean isFirst = self.compareTo(peer) < 0;
    byte[] first = isFirst ? here : there;
    byte[] second = isFirst ? there : here;
    id = ByteBuffer.wrap(key.derive("session id", first, second)).getInt();
    try {
      cipher = Cipher.getInstance("AES/GCM/NoPadding");
    } catch (GeneralSecurityException e) {
      // Every Java platform has it (javax.crypto.Cipher), and Android since version 2.3.
      throw new IllegalStateException("AES-GCM", e);
    }
  }

  private static byte[] end(RobotId robot, Start start) {
    byte[] name = robot.name().getBytes(StandardCharsets.US_ASCII);
    ByteBuffer end = ByteBuffer.allocate(name.length + Start.BYTES);
    end.put(name);
    start.write(end);
    return end.array();
  }

  /**
   * Seals a datagram, with a new count even if it was sent before.
   *
   * @param bodyAt length of its header
   * @param out receives {@code length + BYTES} bytes from its start; not {@code datagram}
   */
  public void seal(byte[] datagram, int bodyAt, int length, byte[] out) {
    transmissions++;
    System.arraycopy(datagram, 0, out, 0, bodyAt);
    ByteBuffer.wrap(out)
        .putInt(length + TAG_BYTES, id)
        .putLong(length + TAG_BYTES + ID_BYTES, transmissions);
    try {
      begin(Cipher.ENCRYPT_MODE, sendKey, transmissions);
      cipher.updateAAD(datagram, 0, bodyAt);
      cipher.doFinal(datagram, bodyAt, length - bodyAt, out, bodyAt);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("a datagram of " + length + " bytes", e);
    }
    if (watch != null) {
      watch.sealed(this, datagram, bodyAt, length, out);
    }
  }

  /** Whether a sealed datagram is of this session, by its id in clear. */
  public boolean isOf(byte[] sealed, int length) {
    return ByteBuffer.wrap(sealed).getInt(length - Long.BYTES - ID_BYTES) == id;
  }

  /** The count of a sealed datagram, from 1. */
  public static long count(byte[] sealed, int length) {
    return ByteBuffer.wrap(sealed).getLong(length - Long.BYTES);
  }

  /**
   * Opens a datagram that the other end sealed.
   *
   * @param length of the sealed datagram, at least {@code bodyAt + BYTES}
   * @param out receives {@code length - BYTES} bytes from its start; not {@code sealed}
   * @return whether the other end sealed exactly these bytes; if not, {@code out} is undefined
   */
  public boolean open(byte[] sealed, int bodyAt, int length, byte[] out) {
    System.arraycopy(sealed, 0, out, 0, bodyAt);
    try {
      begin(Cipher.DECRYPT_MODE, receiveKey, count(sealed, length));
      cipher.updateAAD(sealed, 0, bodyAt);
      cipher.doFinal(sealed, bodyAt, length - ID_BYTES - Long.BYTES - bodyAt, out, bodyAt);
      return true;
    } catch (AEADBadTagException e) {
      return false;
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("a datagram of " + length + " bytes", e);
    }
  }

  private void begin(int mode, SecretKeySpec key, long count) throws GeneralSecurityException {
    ByteBuffer.wrap(iv).putLong(IV_BYTES - Long.BYTES, count);
    cipher.init(mode, key, new GCMParameterSpec(Byte.SIZE * TAG_BYTES, iv));
  }
}

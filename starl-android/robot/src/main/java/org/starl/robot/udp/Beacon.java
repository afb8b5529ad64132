package org.starl.robot.udp;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.session.Nonce;
import org.starl.session.Start;

/**
 * Announces a start of a robot's program to all robots, or proves it to one: a beacon to one robot
 * contains that robot's nonce and is signed with the key of the two. As bytes, big-endian: magic {@code
 * SB}, version 2, the answer, 1 each; the key's id, 4, or 0; the start's epoch, boot and nonce, 8, 4 and
 * 16; the count, 8; the echo, 16; the length and the text of the robot's name, and of the name of the
 * robot to which it is sent, empty for all; the address's length (0, 4 or 16) and the address; the port,
 * 2; and with a key the first 16 bytes of HMAC-SHA256 over all that.
 *
 * @param start of the sender's program
 * @param count number of this beacon since that start, from 1
 * @param address the sender's; null if it is the datagram's source address
 * @param to null for all robots; then it is not signed, and only a hint where the sender is
 * @param echo the nonce of the last beacon heard from {@code to}; or {@link Nonce#NONE}
 * @param answer whether the sender accepts the start with that nonce
 */
record Beacon(
    RobotId robot,
    Start start,
    long count,
    @Nullable InetAddress address,
    int port,
    @Nullable RobotId to,
    Nonce echo,
    Answer answer) {

  static final int MAX_BYTES = 161;

  private static final byte MAGIC_0 = 'S';
  private static final byte MAGIC_1 = 'B';
  private static final byte VERSION = 3;
  private static final int TAG_BYTES = 16;
  private static final int KEY_AT = 4;
  private static final int UNSIGNED = 0;
  private static final int NAMES_AT =
      KEY_AT + Integer.BYTES + Start.BYTES + Long.BYTES + Nonce.BYTES;

  /** Whether a robot accepts a start of another. */
  enum Answer {
    /** It has stored this start: from now on it refuses earlier ones, and other storages. */
    ACCEPTED,
    /** It knows a later start of that robot's program, with the same storage. */
    LATER_START,
    /** It knows another storage of that robot. */
    OTHER_STORAGE,
    /** It does not refuse this start, and has not stored it yet. */
    NOT_STORED;

    boolean isRefusal() {
      return this == LATER_START || this == OTHER_STORAGE;
    }
  }

  /** Whether these bytes begin like a beacon. */
  static boolean isBeacon(byte[] bytes, int length) {
    return length >= 2 && bytes[0] == MAGIC_0 && bytes[1] == MAGIC_1;
  }

  /**
   * Its bytes.
   *
   * @param signing null: it is not signed
   */
  byte[] write(@Nullable SigningKey signing) {
    ByteBuffer out = ByteBuffer.allocate(MAX_BYTES);
    out.put(MAGIC_0).put(MAGIC_1).put(VERSION).put((byte) answer.ordinal());
    out.putInt(signing == null ? UNSIGNED : signing.id());
    start.write(out);
    out.putLong(count);
    echo.write(out);
    text(out, robot.name().getBytes(StandardCharsets.US_ASCII));
    text(out, to == null ? new byte[0] : to.name().getBytes(StandardCharsets.US_ASCII));
    text(out, address == null ? new byte[0] : address.getAddress());
    out.putShort((short) port);
    if (signing != null) {
      out.put(signing.sign(out.array(), out.position()), 0, TAG_BYTES);
    }
    return Arrays.copyOf(out.array(), out.position());
  }

  private static void text(ByteBuffer out, byte[] bytes) {
    out.put((byte) bytes.length).put(bytes);
  }

  /** The id of the key with which well-formed bytes are signed; 0 if they are not. */
  static int keyId(byte[] bytes) {
    return ByteBuffer.wrap(bytes).getInt(KEY_AT);
  }

  /** Whether the bytes, which are signed, are signed with this key. */
  static boolean isSignedWith(SigningKey key, byte[] bytes, int length) {
    byte[] tag = Arrays.copyOfRange(bytes, length - TAG_BYTES, length);
    byte[] expected = Arrays.copyOf(key.sign(bytes, length - TAG_BYTES), TAG_BYTES);
    return MessageDigest.isEqual(expected, tag);
  }

  /** The beacon in these bytes, whose signature is not checked; null if they are malformed. */
  static @Nullable Beacon readOrNull(byte[] bytes, int length) {
    if (length > MAX_BYTES || length < NAMES_AT) {
      return null;
    }
    int signedLength = keyId(bytes) == UNSIGNED ? length : length - TAG_BYTES;
    if (signedLength < NAMES_AT) {
      return null;
    }
    return parseOrNull(ByteBuffer.wrap(bytes, 0, signedLength));
  }

  private static @Nullable Beacon parseOrNull(ByteBuffer in) {
    if (in.get() != MAGIC_0 || in.get() != MAGIC_1 || in.get() != VERSION) {
      return null;
    }
    int answer = in.get();
    in.getInt();
    Start start = Start.read(in);
    long count = in.getLong();
    Nonce echo = Nonce.read(in);
    byte[] name = textOrNull(in);
    byte[] to = textOrNull(in);
    byte[] address = textOrNull(in);
    if (name == null || to == null || address == null || in.remaining() != Short.BYTES) {
      return null;
    }
    int port = in.getShort() & 0xFFFF;
    boolean isInRange =
        answer >= 0
            && answer < Answer.values().length
            && start.boot() > 0
            && !start.nonce().equals(Nonce.NONE)
            && count > 0
            && port > 0;
    RobotId robot = robotOrNull(name);
    if (!isInRange || robot == null || (to.length > 0 && robotOrNull(to) == null)) {
      return null;
    }
    try {
      InetAddress at = address.length == 0 ? null : InetAddress.getByAddress(address);
      // Java converts an IPv6 address that contains an IPv4 address to that IPv4 address.
      boolean isUnchanged = at == null || at.getAddress().length == address.length;
      return isUnchanged
          ? new Beacon(
              robot, start, count, at, port, robotOrNull(to), echo, Answer.values()[answer])
          : null;
    } catch (UnknownHostException e) {
      return null; // not the length of an address
    }
  }

  private static byte @Nullable [] textOrNull(ByteBuffer in) {
    int length = in.hasRemaining() ? in.get() & 0xFF : Integer.MAX_VALUE;
    if (length > in.remaining()) {
      return null;
    }
    byte[] text = new byte[length];
    in.get(text);
    return text;
  }

  private static @Nullable RobotId robotOrNull(byte[] name) {
    String text = new String(name, StandardCharsets.US_ASCII);
    return RobotId.isValid(text) ? new RobotId(text) : null;
  }

  /**
   * Whether it came from the address that it names. If not, another host has forwarded it.
   */
  boolean isFrom(InetSocketAddress source) {
    return source.getPort() == port && (address == null || address.equals(source.getAddress()));
  }
}

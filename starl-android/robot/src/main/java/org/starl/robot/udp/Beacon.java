package org.starl.robot.udp;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import javax.crypto.Mac;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;

/**
 * Announces a robot: its name and its radio's address, signed with the deployment's key. As bytes,
 * big-endian: magic {@code SB}, version 1, 0; {@code start} and {@code count}, 8 each; the name's length
 * and the name; the address's length (0, 4 or 16) and the address; the port, 2; and with a key the first
 * 16 bytes of HMAC-SHA256 over all that.
 *
 * @param start number of the sender's start, larger at each start
 * @param count number of this beacon since that start, from 1
 * @param address null if it is the datagram's source address
 */
record Beacon(RobotId robot, long start, long count, @Nullable InetAddress address, int port) {

  static final int MAX_BYTES = 128;

  private static final byte MAGIC_0 = 'S';
  private static final byte MAGIC_1 = 'B';
  private static final byte VERSION = 1;
  private static final int TAG_BYTES = 16;
  private static final int LEAST_BYTES = 2 + 2 + 8 + 8 + 2 + 1 + 2;

  /** Whether these bytes begin like a beacon. */
  static boolean isBeacon(byte[] bytes, int length) {
    return length >= 2 && bytes[0] == MAGIC_0 && bytes[1] == MAGIC_1;
  }

  /** Reads and makes beacons under one key; for one thread. */
  static final class Codec {
    private final @Nullable Mac mac;

    /** @param key null: beacons are not signed */
    Codec(@Nullable DeploymentKey key) {
      mac = key == null ? null : key.newMac();
    }

    boolean isSigned() {
      return mac != null;
    }

    byte[] write(Beacon beacon) {
      byte[] name = beacon.robot.name().getBytes(StandardCharsets.US_ASCII);
      byte[] address = beacon.address == null ? new byte[0] : beacon.address.getAddress();
      ByteBuffer out = ByteBuffer.allocate(MAX_BYTES);
      out.put(MAGIC_0).put(MAGIC_1).put(VERSION).put((byte) 0);
      out.putLong(beacon.start).putLong(beacon.count);
      out.put((byte) name.length).put(name);
      out.put((byte) address.length).put(address);
      out.putShort((short) beacon.port);
      byte[] signed = Arrays.copyOf(out.array(), out.position());
      if (mac != null) {
        out.put(mac.doFinal(signed), 0, TAG_BYTES);
      }
      return Arrays.copyOf(out.array(), out.position());
    }

    /** The beacon; null if it is malformed, or not signed with the key. */
    @Nullable Beacon readOrNull(byte[] bytes, int length) {
      int tagBytes = mac == null ? 0 : TAG_BYTES;
      int signedLength = length - tagBytes;
      if (length > MAX_BYTES || signedLength < LEAST_BYTES || !isGenuine(bytes, signedLength)) {
        return null;
      }
      return parseOrNull(ByteBuffer.wrap(bytes, 0, signedLength));
    }

    private boolean isGenuine(byte[] bytes, int signedLength) {
      if (mac == null) {
        return true;
      }
      mac.update(bytes, 0, signedLength);
      byte[] tag = Arrays.copyOfRange(bytes, signedLength, signedLength + TAG_BYTES);
      return MessageDigest.isEqual(Arrays.copyOf(mac.doFinal(), TAG_BYTES), tag);
    }

    private static @Nullable Beacon parseOrNull(ByteBuffer in) {
      if (in.get() != MAGIC_0 || in.get() != MAGIC_1 || in.get() != VERSION || in.get() != 0) {
        return null;
      }
      long start = in.getLong();
      long count = in.getLong();
      int nameLength = in.get() & 0xFF;
      if (nameLength + 1 + 2 > in.remaining()) {
        return null;
      }
      byte[] nameBytes = new byte[nameLength];
      in.get(nameBytes);
      int addressLength = in.get() & 0xFF;
      if (addressLength + 2 != in.remaining()) {
        return null;
      }
      byte[] address = new byte[addressLength];
      in.get(address);
      int port = in.getShort() & 0xFFFF;
      String name = new String(nameBytes, StandardCharsets.US_ASCII);
      if (count < 1 || port == 0 || !RobotId.isValid(name)) {
        return null;
      }
      try {
        InetAddress at = addressLength == 0 ? null : InetAddress.getByAddress(address);
        // Java converts an IPv6 address that contains an IPv4 address to that IPv4 address.
        boolean isUnchanged = at == null || at.getAddress().length == addressLength;
        return isUnchanged ? new Beacon(new RobotId(name), start, count, at, port) : null;
      } catch (UnknownHostException e) {
        return null; // not the length of an address
      }
    }
  }

  /**
   * The robot's address, if the beacon came from {@code source}; null if the beacon names another
   * sender: then another host has forwarded it.
   */
  @Nullable InetSocketAddress reachedFrom(InetSocketAddress source) {
    boolean isDirect =
        source.getPort() == port && (address == null || address.equals(source.getAddress()));
    return isDirect ? source : null;
  }
}

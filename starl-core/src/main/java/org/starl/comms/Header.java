package org.starl.comms;

import org.jspecify.annotations.Nullable;
import org.starl.platform.Radio;
import org.starl.session.Session;
import org.starl.shape.WireReader;

/**
 * The header of a received datagram: its fields, and the positions of its names
 * (docs/wire-format.md). One object parses one datagram after another.
 */
final class Header {

  static final int MAGIC_0 = 'S';
  static final int MAGIC_1 = 'L';
  static final int VERSION = 1;

  /** Maximum length in bytes, without authentication. */
  static final int MAX_BYTES = Radio.MAX_BYTES - Session.BYTES;

  static final int PLAIN = 1;
  static final int RELIABLE = 2;
  static final int ACK = 3;

  static final int LENGTH_AT = 4;
  static final int BOOT_AT = 6;
  static final int NUMBER_AT = 10;
  static final int CLOCK_AT = 18;
  static final int NAMES_AT = 26;

  /** Datagrams with a larger clock are dropped, so that no datagram can make a clock overflow. */
  static final long MAX_CLOCK = (1L << 62) - 1;

  /** The datagram's bytes: valid only while the radio hands them over. */
  byte[] bytes = {};

  /** Reads the header and, after {@link #parse}, the body. */
  final WireReader in = new WireReader();

  private int length;

  int kind;
  int boot;
  long number;
  long clock;
  int senderAt;
  int senderLength;
  int addresseeAt;
  int addresseeLength;
  int channelAt;
  int channelLength;
  int bodyAt;

  /**
   * Reads everything before the body. Does not check the characters of the names.
   *
   * @return why the datagram is malformed, or null if it is well-formed
   */
  @Nullable DropReason parse(byte[] datagram, int datagramLength) {
    bytes = datagram;
    length = datagramLength;
    if (length < 3) {
      return DropReason.TRUNCATED;
    }
    if (bytes[0] != MAGIC_0 || bytes[1] != MAGIC_1) {
      return DropReason.FOREIGN;
    }
    if (bytes[2] != VERSION) {
      return DropReason.OTHER_VERSION;
    }
    if (length > MAX_BYTES) {
      return DropReason.OVERLONG;
    }
    if (length < NAMES_AT) {
      return DropReason.TRUNCATED;
    }
    in.reset(bytes, 3, length);
    kind = in.u8();
    int stated = in.u16();
    if (stated != length) {
      return stated > length ? DropReason.TRUNCATED : DropReason.OVERLONG;
    }
    boot = in.i32();
    number = in.i64();
    clock = in.i64();
    if (kind < PLAIN || kind > ACK) {
      return DropReason.UNKNOWN_KIND;
    }
    if (boot <= 0 || number <= 0 || clock < 0 || clock > MAX_CLOCK) {
      return DropReason.BAD_FIELD;
    }
    DropReason malformed = parseNames();
    if (malformed == null) {
      in.reset(bytes, bodyAt, length);
    }
    return malformed;
  }

  /** Continues in a copy of the parsed datagram. */
  void continueIn(byte[] copy) {
    bytes = copy;
    in.reset(bytes, bodyAt, length);
  }

  /** Where the body of a well-formed datagram begins. */
  static int bodyAt(byte[] datagram) {
    int at = NAMES_AT;
    for (int name = 0; name < 3; name++) {
      at += 1 + (datagram[at] & 0xFF);
    }
    return at;
  }

  private @Nullable DropReason parseNames() {
    senderAt = NAMES_AT + 1;
    if (senderAt > length) {
      return DropReason.TRUNCATED;
    }
    senderLength = bytes[senderAt - 1] & 0xFF;
    addresseeAt = senderAt + senderLength + 1;
    if (addresseeAt > length) {
      return DropReason.TRUNCATED;
    }
    addresseeLength = bytes[addresseeAt - 1] & 0xFF;
    channelAt = addresseeAt + addresseeLength + 1;
    if (channelAt > length) {
      return DropReason.TRUNCATED;
    }
    channelLength = bytes[channelAt - 1] & 0xFF;
    bodyAt = channelAt + channelLength;
    if (bodyAt > length) {
      return DropReason.TRUNCATED;
    }
    boolean channelIsAsKindSays = (channelLength == 0) == (kind == ACK);
    boolean addresseeIsAsKindSays = addresseeLength > 0 || kind == PLAIN;
    return channelIsAsKindSays && addresseeIsAsKindSays ? null : DropReason.BAD_NAME;
  }
}

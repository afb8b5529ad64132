package org.starl.robot.optitrack;

import java.nio.charset.StandardCharsets;

/**
 * Reads little-endian values one after the other and never throws: what lies beyond the end reads as
 * 0, and from then on the reader {@link #failed}. Allocates nothing but the strings it is asked for.
 */
final class LittleEndianReader {

  /** No name in NatNet is longer, its final NUL included. */
  static final int MAX_NAME_BYTES = 256;

  private final byte[] bytes;
  private final int end;
  private int at;
  private boolean failed;

  /** Over {@code bytes[from..end)}. */
  LittleEndianReader(byte[] bytes, int from, int end) {
    if (from < 0 || from > end || end > bytes.length) {
      throw new IllegalArgumentException(from + " to " + end + " of " + bytes.length + " bytes");
    }
    this.bytes = bytes;
    this.at = from;
    this.end = end;
  }

  boolean failed() {
    return failed;
  }

  int remaining() {
    return end - at;
  }

  int u8() {
    return take(1) ? bytes[at - 1] & 0xff : 0;
  }

  int u16() {
    return take(2) ? (bytes[at - 2] & 0xff) | (bytes[at - 1] & 0xff) << 8 : 0;
  }

  int i32() {
    return take(4) ? intAt(at - 4) : 0;
  }

  long i64() {
    return take(8) ? (intAt(at - 8) & 0xffff_ffffL) | (long) intAt(at - 4) << 32 : 0;
  }

  double f32() {
    return Float.intBitsToFloat(i32());
  }

  /** A UTF-8 string that ends with NUL; fails on one that does not, or not soon enough. */
  String name() {
    int from = at;
    while (at < end && at - from < MAX_NAME_BYTES) {
      if (bytes[at] == 0) {
        at++;
        return new String(bytes, from, at - 1 - from, StandardCharsets.UTF_8);
      }
      at++;
    }
    fail();
    return "";
  }

  /** A string in a field of so many bytes. */
  String fixedName(int size) {
    LittleEndianReader field = section(size);
    String name = field.name();
    failed |= field.failed;
    return name;
  }

  void skipName() {
    int from = at;
    while (at < end && at - from < MAX_NAME_BYTES) {
      at++;
      if (bytes[at - 1] == 0) {
        return;
      }
    }
    fail();
  }

  void skipNames(int count) {
    for (int i = 0; i < count && !failed; i++) {
      skipName();
    }
  }

  /** Fails if there are not so many. */
  void skip(long count) {
    if (count < 0 || count > remaining()) {
      fail();
    } else {
      at += (int) count;
    }
  }

  /** How many elements follow; fails if they cannot, of {@code minBytes} each at least. */
  int count(int minBytes) {
    int count = i32();
    if (count < 0 || (long) count * minBytes > remaining()) {
      fail();
      return 0;
    }
    return count;
  }

  /** A reader of the next {@code size} bytes, which this one leaves out; both fail if too few. */
  LittleEndianReader section(int size) {
    int from = at;
    skip(size);
    LittleEndianReader section =
        new LittleEndianReader(bytes, failed ? end : from, failed ? end : at);
    section.failed = failed;
    return section;
  }

  private boolean take(int count) {
    if (count > remaining()) {
      fail();
      return false;
    }
    at += count;
    return true;
  }

  /** What was read cannot be; nothing more is there. */
  void fail() {
    failed = true;
    at = end;
  }

  private int intAt(int place) {
    return (bytes[place] & 0xff)
        | (bytes[place + 1] & 0xff) << 8
        | (bytes[place + 2] & 0xff) << 16
        | (bytes[place + 3] & 0xff) << 24;
  }
}

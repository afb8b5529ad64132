package org.starl.robot.create;

/**
 * Finds the frames of the robot's sensor stream in arbitrary bytes: {@code 19, n, (packet, data)*,
 * checksum}. It accepts a frame only with the requested packets, in that order, and a correct
 * checksum. Otherwise the search continues with the byte after the false header, so that a bad frame
 * never hides a good one. Never throws, allocates nothing. One thread.
 *
 * <p>The checksum detects every single wrong bit. A frame whose end was lost, completed by the
 * beginning of the next frame, would pass once in 256 times; so the last requested packet must be one
 * byte that is never the header (the mode): the values of an accepted frame are then right. Longer
 * noise passes once in 256 times, and so do two broken frames in a row.
 *
 * <p>Checksum: all bytes of a frame add up to 0 modulo 256. The Create 1 specification's example
 * excludes the header from the sum, but drivers in use include it. So with a Create 1 the decoder
 * learns the rule from {@value #TO_LEARN} frames in a row that agree, and keeps it.
 */
final class StreamDecoder {

  /** Receives good frames. */
  interface Receiver {
    void frame(StreamDecoder decoder);
  }

  /** Number of frames in a row that must agree on a rule before the decoder accepts a frame. */
  static final int TO_LEARN = 3;

  private static final int UNKNOWN = -1;

  private final int[] packets;
  private final boolean mayLearn;
  private final byte[] template;
  private final boolean[] isFixed;
  private final byte[] frame;
  private final int[] values = new int[Packets.LAST + 1];
  private int filled;
  private int rule;
  private int candidate;
  private int agreed;
  private long frames;
  private long badChecksums;
  private long dropped;

  /**
   * @param packets single packets, in the requested order; the last has one byte, never {@value
   *     Packets#FRAME_HEADER}
   */
  StreamDecoder(CreateModel model, int[] packets) {
    if (Packets.bytes(packets[packets.length - 1]) != 1) {
      throw new IllegalArgumentException("the last packet has two bytes");
    }
    this.packets = packets.clone();
    this.mayLearn = model == CreateModel.CREATE_1;
    int data = 0;
    for (int packet : packets) {
      data += 1 + Packets.bytes(packet);
    }
    template = new byte[data + 3];
    isFixed = new boolean[template.length];
    frame = new byte[template.length];
    fix(0, Packets.FRAME_HEADER);
    fix(1, data);
    int at = 2;
    for (int packet : packets) {
      fix(at, packet);
      at += 1 + Packets.bytes(packet);
    }
    reset();
  }

  /** Drops a partial frame and the learned rule, for a new link. Keeps the counters. */
  void reset() {
    dropped += filled;
    filled = 0;
    rule = mayLearn ? UNKNOWN : 0;
    candidate = UNKNOWN;
    agreed = 0;
  }

  /** Bytes of a frame. */
  int frameBytes() {
    return frame.length;
  }

  void accept(byte[] bytes, int length, Receiver receiver) {
    for (int i = 0; i < length; i++) {
      frame[filled++] = bytes[i];
      if (!matches(filled - 1, bytes[i])) {
        shift();
      } else if (filled == frame.length) {
        check(receiver);
      }
    }
  }

  /** The value of {@code packet}, a requested one, in the last good frame. */
  int value(int packet) {
    return values[packet];
  }

  /** Good frames so far. */
  long frames() {
    return frames;
  }

  /** Number of frames with a wrong checksum. */
  long badChecksums() {
    return badChecksums;
  }

  /** Bytes that belonged to no good frame. */
  long dropped() {
    return dropped;
  }

  private void fix(int at, int value) {
    template[at] = (byte) value;
    isFixed[at] = true;
  }

  private boolean matches(int at, byte value) {
    if (isFixed[at]) {
      return value == template[at];
    }
    return at != template.length - 2 || value != Packets.FRAME_HEADER;
  }

  private void check(Receiver receiver) {
    int sum = 0;
    for (byte b : frame) {
      sum += b;
    }
    sum &= 0xFF;
    boolean isSum = sum == 0 || (mayLearn && sum == Packets.FRAME_HEADER);
    if (rule == UNKNOWN && isSum) {
      learn(sum);
      dropped += rule == UNKNOWN ? frame.length : 0;
    }
    if (rule == sum) {
      store();
      filled = 0;
      receiver.frame(this);
    } else if (rule == UNKNOWN && isSum) {
      filled = 0;
    } else {
      badChecksums++;
      agreed = 0;
      shift();
    }
  }

  private void learn(int sum) {
    agreed = sum == candidate ? agreed + 1 : 1;
    candidate = sum;
    if (agreed >= TO_LEARN) {
      rule = sum;
    }
  }

  private void store() {
    frames++;
    int at = 2;
    for (int packet : packets) {
      values[packet] = valueAt(at + 1, packet);
      at += 1 + Packets.bytes(packet);
    }
  }

  private int valueAt(int at, int packet) {
    boolean isSigned = Packets.isSigned(packet);
    byte first = frame[at];
    if (Packets.bytes(packet) == 1) {
      return isSigned ? first : first & 0xFF;
    }
    int value = (first & 0xFF) << 8 | (frame[at + 1] & 0xFF);
    return isSigned ? (short) value : value;
  }

  /** Drops bytes from the front until the rest may be the beginning of a frame. */
  private void shift() {
    int from = 1;
    while (from < filled && !couldBegin(from)) {
      from++;
    }
    dropped += from;
    System.arraycopy(frame, from, frame, 0, filled - from);
    filled -= from;
  }

  private boolean couldBegin(int from) {
    for (int at = 0; from + at < filled; at++) {
      if (!matches(at, frame[from + at])) {
        return false;
      }
    }
    return true;
  }
}

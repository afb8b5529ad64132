package org.starl.shape;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * Reads the fields that {@link WireWriter} wrote; invalid bytes cause a {@link
 * WireFormatException}.
 */
public final class WireReader {

  private static final byte[] NOTHING = new byte[0];

  private byte[] buffer = NOTHING;
  private int position;
  private int end;

  public WireReader() {}

  public WireReader(byte[] bytes) {
    reset(bytes, 0, bytes.length);
  }

  /** Starts reading at {@code from}; {@code to} is the end. */
  public void reset(byte[] bytes, int from, int to) {
    buffer = bytes;
    position = from;
    end = to;
  }

  public int remaining() {
    return end - position;
  }

  public int u8() {
    need(1);
    return buffer[position++] & 0xFF;
  }

  public boolean bool() {
    int value = u8();
    if (value > 1) {
      throw new WireFormatException("boolean " + value);
    }
    return value == 1;
  }

  public int u16() {
    need(2);
    int value = (buffer[position] & 0xFF) << 8 | (buffer[position + 1] & 0xFF);
    position += 2;
    return value;
  }

  public int i32() {
    need(4);
    int value = 0;
    for (int i = 0; i < 4; i++) {
      value = value << 8 | (buffer[position++] & 0xFF);
    }
    return value;
  }

  public long i64() {
    need(Long.BYTES);
    long value = getI64(buffer, position);
    position += Long.BYTES;
    return value;
  }

  /**
   * Reads a number of at least {@code least}.
   *
   * @param what the number, for the error
   */
  public long i64(long least, String what) {
    long value = i64();
    if (value < least) {
      throw new WireFormatException(what + " " + value);
    }
    return value;
  }

  /** Reads {@code count} items. */
  public <T> List<T> list(int count, Function<WireReader, T> item) {
    List<T> items = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      items.add(item.apply(this));
    }
    return items;
  }

  /** Reads the eight bytes at {@code at}, big-endian. */
  static long getI64(byte[] bytes, int at) {
    long value = 0;
    for (int i = 0; i < Long.BYTES; i++) {
      value = value << 8 | (bytes[at + i] & 0xFF);
    }
    return value;
  }

  /** Reads a double; infinities and NaN are invalid. */
  public double f64() {
    double value = Double.longBitsToDouble(i64());
    if (!Double.isFinite(value)) {
      throw new WireFormatException("number " + value);
    }
    return value;
  }

  public String string() {
    return utf8(u8());
  }

  /** Reads everything that is left, as UTF-8. */
  public String text() {
    return utf8(remaining());
  }

  private String utf8(int bytes) {
    need(bytes);
    if (isAscii(buffer, position, bytes)) {
      position += bytes;
      return new String(buffer, position - bytes, bytes, StandardCharsets.ISO_8859_1);
    }
    try {
      String value =
          StandardCharsets.UTF_8
              .newDecoder()
              .onMalformedInput(CodingErrorAction.REPORT)
              .onUnmappableCharacter(CodingErrorAction.REPORT)
              .decode(ByteBuffer.wrap(buffer, position, bytes))
              .toString();
      position += bytes;
      return value;
    } catch (CharacterCodingException e) {
      throw new WireFormatException("a string that is not UTF-8");
    }
  }

  public byte[] bytes() {
    int bytes = u16();
    need(bytes);
    byte[] value = Arrays.copyOfRange(buffer, position, position + bytes);
    position += bytes;
    return value;
  }

  public RobotId robot() {
    String name = string();
    if (!RobotId.isValid(name)) {
      throw new WireFormatException("robot name");
    }
    return new RobotId(name);
  }

  public ProcessId process() {
    RobotId robot = robot();
    return new ProcessId(robot, i64(1, "incarnation"));
  }

  private static boolean isAscii(byte[] bytes, int from, int length) {
    for (int i = from; i < from + length; i++) {
      if (bytes[i] < 0) {
        return false;
      }
    }
    return true;
  }

  /** Checks that everything was read. */
  public void expectEnd() {
    if (position != end) {
      throw new WireFormatException(remaining() + " bytes too many");
    }
  }

  private void need(int bytes) {
    if (end - position < bytes) {
      throw new WireFormatException("ends " + (bytes - remaining()) + " bytes early");
    }
  }
}

package org.starl.shape;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Writes JSON in UTF-8, without white space, into a growing buffer that is reused. */
public final class JsonWriter {

  private static final String HEX = "0123456789abcdef";

  private byte[] bytes = new byte[1 << 16];
  private int length;

  /** Number of bytes written. */
  public int length() {
    return length;
  }

  /** Forgets what was written. */
  public void clear() {
    length = 0;
  }

  /** Writes all to {@code out}; the buffer keeps it. */
  public void writeTo(OutputStream out) throws IOException {
    out.write(bytes, 0, length);
  }

  /** The text written since {@code from}. */
  public String textFrom(int from) {
    return new String(bytes, from, length - from, StandardCharsets.UTF_8);
  }

  /** Writes one ASCII character as it is. */
  public void ascii(char c) {
    room(1);
    bytes[length++] = (byte) c;
  }

  /** Writes ASCII characters as they are. */
  public void ascii(String text) {
    room(text.length());
    for (int i = 0; i < text.length(); i++) {
      bytes[length++] = (byte) text.charAt(i);
    }
  }

  /** Writes a decimal integer. */
  public void number(long value) {
    if (value == Long.MIN_VALUE) {
      ascii("-9223372036854775808");
      return;
    }
    long rest = value;
    if (rest < 0) {
      ascii('-');
      rest = -rest;
    }
    int digits = 1;
    for (long power = rest / 10; power > 0; power /= 10) {
      digits++;
    }
    room(digits);
    for (int i = length + digits - 1; i >= length; i--) {
      bytes[i] = (byte) ('0' + rest % 10);
      rest /= 10;
    }
    length += digits;
  }

  /**
   * Writes a number exactly: the shortest text that reads back as the same bits. JSON has no infinite
   * numbers: they, and NaN, are strings.
   */
  public void number(double value) {
    if (Double.isFinite(value)) {
      ascii(Double.toString(value));
    } else {
      string(Double.toString(value));
    }
  }

  /** Writes a JSON value that is text already, as {@link JsonReader#value} reads it. */
  public void value(String json) {
    byte[] utf8 = json.getBytes(StandardCharsets.UTF_8);
    room(utf8.length);
    System.arraycopy(utf8, 0, bytes, length, utf8.length);
    length += utf8.length;
  }

  /** Writes a JSON string with its quotes. */
  public void string(String text) {
    ascii('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c >= 0x20 && c < 0x7F) {
        if (c == '"' || c == '\\') {
          ascii('\\');
        }
        ascii(c);
      } else if (Character.isHighSurrogate(c)
          && i + 1 < text.length()
          && Character.isLowSurrogate(text.charAt(i + 1))) {
        i++;
        utf8(Character.toCodePoint(c, text.charAt(i)));
      } else if (needsEscape(c)) {
        escape(c);
      } else {
        utf8(c);
      }
    }
    ascii('"');
  }

  // Escapes more than JSON requires: characters that some readers take as line ends (U+0085,
  // U+2028, U+2029), and halves of surrogate pairs, which UTF-8 cannot represent.
  private static boolean needsEscape(char c) {
    return c < 0xA0 || c == 0x2028 || c == 0x2029 || Character.isSurrogate(c);
  }

  private void escape(char c) {
    switch (c) {
      case '\n' -> ascii("\\n");
      case '\r' -> ascii("\\r");
      case '\t' -> ascii("\\t");
      default -> {
        ascii("\\u");
        for (int shift = 12; shift >= 0; shift -= 4) {
          ascii(HEX.charAt((c >> shift) & 0xF));
        }
      }
    }
  }

  // Only for code points above U+007F.
  private void utf8(int codePoint) {
    room(4);
    if (codePoint < 0x800) {
      bytes[length++] = (byte) (0xC0 | (codePoint >> 6));
    } else if (codePoint < 0x10000) {
      bytes[length++] = (byte) (0xE0 | (codePoint >> 12));
      sixBits(codePoint, 6);
    } else {
      bytes[length++] = (byte) (0xF0 | (codePoint >> 18));
      sixBits(codePoint, 12);
      sixBits(codePoint, 6);
    }
    sixBits(codePoint, 0);
  }

  private void sixBits(int codePoint, int shift) {
    bytes[length++] = (byte) (0x80 | ((codePoint >> shift) & 0x3F));
  }

  private void room(int more) {
    if (length + more > bytes.length) {
      bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + more));
    }
  }
}

package org.starl.robot.udp;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * File names of keys: {@code a-z 0-9 _ -} and inner dots as they are, every other byte of UTF-8 as
 * {@code %xx}, then {@code .value}. Capitals are escaped because some file systems ignore case.
 */
final class StableFiles {

  private static final String SUFFIX = ".value";
  private static final int MAX_LENGTH = 200;

  private StableFiles() {}

  static String name(String key) {
    String name = encode(key);
    if (name.isEmpty() || name.length() > MAX_LENGTH) {
      throw new IllegalArgumentException("key '" + key + "': expected 1 to some 200 letters");
    }
    return name + SUFFIX;
  }

  private static String encode(String key) {
    StringBuilder name = new StringBuilder();
    for (byte b : key.getBytes(StandardCharsets.UTF_8)) {
      if (isPlain(b) && !(b == '.' && name.length() == 0)) {
        name.append((char) b);
      } else {
        name.append('%').append(hex(b >> 4)).append(hex(b));
      }
    }
    return name.toString();
  }

  /** The key of a file whose name {@link #name} made. */
  static String key(Path file) throws IOException {
    String name = String.valueOf(file.getFileName());
    if (name.endsWith(SUFFIX)) {
      String encoded = name.substring(0, name.length() - SUFFIX.length());
      String key = decode(encoded);
      if (!key.isEmpty() && encode(key).equals(encoded)) {
        return key;
      }
    }
    throw new IOException(file + ": expected a key's file, <key>" + SUFFIX);
  }

  /** The unescaped name; arbitrary if the name is malformed. */
  private static String decode(String name) {
    byte[] bytes = new byte[name.length()];
    int count = 0;
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      if (c == '%' && i + 2 < name.length()) {
        int high = Character.digit(name.charAt(i + 1), 16);
        int low = Character.digit(name.charAt(i + 2), 16);
        bytes[count++] = (byte) (high << 4 | low);
        i += 2;
      } else {
        bytes[count++] = (byte) c;
      }
    }
    return new String(bytes, 0, count, StandardCharsets.UTF_8);
  }

  private static boolean isPlain(byte b) {
    return (b >= 'a' && b <= 'z') || (b >= '0' && b <= '9') || b == '_' || b == '-' || b == '.';
  }

  private static char hex(int value) {
    return Character.forDigit(value & 0xF, 16);
  }
}

package org.starl.sim.export;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;

/**
 * Compresses bytes into one LZ4 frame (github.com/lz4/lz4, doc/lz4_Frame_format.md): independent
 * blocks, without checksums of the content. Fast rather than small.
 */
final class Lz4Frame {

  private static final int MAGIC = 0x184D2204;

  /** Version 1, independent blocks. */
  private static final int FLAGS = 0x60;

  /** Blocks of at most 4 MiB. */
  private static final int BLOCK_SIZE_CODE = 0x70;

  private static final int MOST_BLOCK_BYTES = 4 << 20;
  private static final int UNCOMPRESSED = 1 << 31;

  private static final int LEAST_MATCH = 4;
  private static final int MOST_DISTANCE = 0xFFFF;

  /** A block ends with literals: no match may begin in its last 12 bytes, or reach its last 5. */
  private static final int NO_MATCH_BEGINS = 12;

  private static final int LAST_LITERALS = 5;
  private static final int HASH_BITS = 14;
  private static final int LONG_LENGTH = 15;

  /** The constants of xxHash32. */
  private static final int PRIME_1 = -1640531535;

  private static final int PRIME_2 = -2048144777;
  private static final int PRIME_3 = -1028477379;
  private static final int PRIME_5 = 374761393;

  private Lz4Frame() {}

  /** The frame of the first {@code length} bytes. */
  static byte[] of(byte[] bytes, int length) {
    ByteArrayOutputStream out = new ByteArrayOutputStream(length / 4 + 64);
    number(out, MAGIC);
    out.write(FLAGS);
    out.write(BLOCK_SIZE_CODE);
    out.write(checksum(FLAGS, BLOCK_SIZE_CODE) >>> 8);
    for (int from = 0; from < length; from += MOST_BLOCK_BYTES) {
      int to = Math.min(length, from + MOST_BLOCK_BYTES);
      byte[] block = block(bytes, from, to);
      if (block.length < to - from) {
        number(out, block.length);
        out.writeBytes(block);
      } else {
        number(out, (to - from) | UNCOMPRESSED);
        out.write(bytes, from, to - from);
      }
    }
    number(out, 0); // the end
    return out.toByteArray();
  }

  private static void number(ByteArrayOutputStream out, int value) {
    for (int shift = 0; shift < Integer.SIZE; shift += 8) {
      out.write(value >>> shift);
    }
  }

  /** The hash xxHash32 of two bytes, with seed 0. */
  private static int checksum(int first, int second) {
    int hash = PRIME_5 + 2;
    for (int one : new int[] {first, second}) {
      hash = Integer.rotateLeft(hash + one * PRIME_5, 11) * PRIME_1;
    }
    hash = (hash ^ (hash >>> 15)) * PRIME_2;
    hash = (hash ^ (hash >>> 13)) * PRIME_3;
    return hash ^ (hash >>> 16);
  }

  private static byte[] block(byte[] in, int from, int to) {
    ByteArrayOutputStream out = new ByteArrayOutputStream((to - from) / 4 + 64);
    int[] latest = new int[1 << HASH_BITS];
    Arrays.fill(latest, -1);
    int written = from;
    int at = from;
    while (at < to - NO_MATCH_BEGINS) {
      int hash = (four(in, at) * PRIME_1) >>> (Integer.SIZE - HASH_BITS);
      int match = latest[hash];
      latest[hash] = at;
      if (match < 0 || at - match > MOST_DISTANCE || four(in, match) != four(in, at)) {
        at++;
        continue;
      }
      int length = LEAST_MATCH;
      while (at + length < to - LAST_LITERALS && in[at + length] == in[match + length]) {
        length++;
      }
      sequence(out, in, written, at, length - LEAST_MATCH);
      out.write(at - match);
      out.write((at - match) >>> 8);
      longer(out, length - LEAST_MATCH);
      at += length;
      written = at;
    }
    sequence(out, in, written, to, 0);
    return out.toByteArray();
  }

  /** A token with both lengths, and the literals. */
  private static void sequence(ByteArrayOutputStream out, byte[] in, int from, int to, int match) {
    int literals = to - from;
    out.write((Math.min(literals, LONG_LENGTH) << 4) | Math.min(match, LONG_LENGTH));
    longer(out, literals);
    out.write(in, from, literals);
  }

  /** The rest of a length that does not fit into the token. */
  private static void longer(ByteArrayOutputStream out, int length) {
    if (length >= LONG_LENGTH) {
      int rest = length - LONG_LENGTH;
      for (; rest >= 255; rest -= 255) {
        out.write(255);
      }
      out.write(rest);
    }
  }

  private static int four(byte[] in, int at) {
    return (in[at] & 0xFF)
        | (in[at + 1] & 0xFF) << 8
        | (in[at + 2] & 0xFF) << 16
        | (in[at + 3] & 0xFF) << 24;
  }
}

package org.starl.sim.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;

/** Frames are decoded as the format's description says. */
class Lz4FrameTest {

  /** Reads one frame; an independent reading of the format. */
  private static byte[] decoded(byte[] frame) {
    assertThat(Arrays.copyOf(frame, 6)).containsExactly(0x04, 0x22, 0x4D, 0x18, 0x60, 0x70);
    assertThat(frame[6]).isEqualTo((byte) 0x73); // as the program lz4 writes it for these flags
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int at = 7;
    while (true) {
      int size = number(frame, at, 4);
      at += 4;
      if (size == 0) {
        assertThat(at).isEqualTo(frame.length);
        return out.toByteArray();
      }
      int length = size & Integer.MAX_VALUE;
      if (size < 0) {
        out.write(frame, at, length);
      } else {
        out.writeBytes(block(frame, at, at + length));
      }
      at += length;
    }
  }

  private static int number(byte[] in, int at, int bytes) {
    int value = 0;
    for (int i = 0; i < bytes; i++) {
      value |= (in[at + i] & 0xFF) << (8 * i);
    }
    return value;
  }

  private static byte[] block(byte[] in, int from, int to) {
    byte[] out = new byte[5 << 20];
    int size = 0;
    int at = from;
    while (at < to) {
      int token = in[at++] & 0xFF;
      int literals = token >> 4;
      for (int more = literals == 15 ? 255 : 0; more == 255; literals += more) {
        more = in[at++] & 0xFF;
      }
      System.arraycopy(in, at, out, size, literals);
      at += literals;
      size += literals;
      if (at == to) {
        assertThat(literals).isGreaterThanOrEqualTo(Math.min(5, size)); // the end's rule
        break;
      }
      int distance = number(in, at, 2);
      at += 2;
      assertThat(distance).isBetween(1, size);
      int match = token & 15;
      for (int more = match == 15 ? 255 : 0; more == 255; match += more) {
        more = in[at++] & 0xFF;
      }
      for (int i = 0; i < match + 4; i++, size++) {
        out[size] = out[size - distance];
      }
    }
    return Arrays.copyOf(out, size);
  }

  @Property(tries = 300)
  void whatIsCompressedIsDecoded(@ForAll @Size(max = 400) byte[] bytes) {
    assertThat(decoded(Lz4Frame.of(bytes, bytes.length))).isEqualTo(bytes);
  }

  @Property(tries = 100)
  void repeatedBytesAreDecodedToo(
      @ForAll @IntRange(min = 1, max = 40) int period,
      @ForAll @IntRange(max = 3000) int length,
      @ForAll long seed) {
    Random random = new Random(seed);
    byte[] part = new byte[period];
    random.nextBytes(part);
    byte[] bytes = new byte[length];
    for (int i = 0; i < length; i++) {
      bytes[i] = random.nextInt(50) == 0 ? (byte) random.nextInt() : part[i % period];
    }
    assertThat(decoded(Lz4Frame.of(bytes, length))).isEqualTo(bytes);
  }

  @Example
  void severalBlocksAndFarMatches() {
    byte[] bytes = new byte[(4 << 20) + 100_000];
    Random random = new Random(1);
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) (i % 70_000 < 200 ? i % 70_000 : i % 9 == 0 ? random.nextInt() : 7);
    }
    byte[] frame = Lz4Frame.of(bytes, bytes.length);
    assertThat(decoded(frame)).isEqualTo(bytes);
    assertThat(frame.length).isLessThan(bytes.length / 2);
  }
}

package org.starl.sim.check;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.function.Consumer;
import org.starl.random.Rng;

/**
 * Malformed inputs for tests of readers: random bytes, and valid inputs that were cut, changed,
 * lengthened, spliced and repeated.
 *
 * <p>The test is a method {@code fuzzerTestOneInput(byte[])}, which throws if the reader fails its
 * contract; coverage-guided fuzzers of the JVM call methods of that name too.
 *
 * <p>System properties: {@code starl.fuzz} is the number of inputs, {@code starl.fuzz.seed} their
 * seed, {@code starl.fuzz.samples} a folder to which the valid inputs are written, as a fuzzer's
 * corpus.
 */
public final class MalformedBytes {

  private static final int USUAL_COUNT = 5_000;
  private static final int LONGEST_NOISE = 300;
  private static final int[] HARMFUL = {0, 1, -1, 0x7F, 0x80, 0xFF, 1 << 31, ~(1 << 31), 1 << 16};

  private final Rng rng;
  private final List<byte[]> samples;

  /** @param samples valid inputs, at least one */
  public MalformedBytes(long seed, List<byte[]> samples) {
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("no samples: expected at least one good input");
    }
    this.rng = new Rng(seed);
    this.samples = List.copyOf(samples);
  }

  /**
   * Passes all samples and then malformed inputs to {@code target}.
   *
   * @throws AssertionError when the target throws; it shows the input and how to repeat it
   */
  public static void feed(List<byte[]> samples, Consumer<byte[]> target) {
    long seed = Long.getLong("starl.fuzz.seed", 1);
    int count = Integer.getInteger("starl.fuzz", USUAL_COUNT);
    keep(samples);
    for (byte[] sample : samples) {
      feed(sample.clone(), target, "a sample");
    }
    MalformedBytes malformed = new MalformedBytes(seed, samples);
    for (int i = 0; i < count; i++) {
      feed(malformed.next(), target, "number " + i + " of -Dstarl.fuzz.seed=" + seed);
    }
  }

  /** The next input; the caller may modify it. */
  public byte[] next() {
    byte[] sample = any();
    byte[] bytes =
        switch (rng.nextInt(6)) {
          case 0 -> noise(rng.nextInt(LONGEST_NOISE));
          case 1 -> Arrays.copyOf(sample, rng.nextInt(sample.length + 1));
          case 2 -> Arrays.copyOf(sample, sample.length + rng.nextInt(9));
          case 3 -> joined(sample, rng.nextInt(sample.length + 1), any());
          case 4 -> joined(sample, rng.nextInt(sample.length + 1), sample);
          default -> sample.clone();
        };
    for (int i = rng.nextInt(5); i > 0 && bytes.length > 0; i--) {
      change(bytes);
    }
    return bytes;
  }

  private byte[] any() {
    return samples.get(rng.nextInt(samples.size()));
  }

  private byte[] noise(int length) {
    byte[] bytes = new byte[length];
    for (int i = 0; i < length; i++) {
      bytes[i] = (byte) rng.nextInt(256);
    }
    return bytes;
  }

  /** The head of one sample followed by the tail of another one. */
  private byte[] joined(byte[] head, int headLength, byte[] other) {
    int from = rng.nextInt(other.length + 1);
    byte[] bytes = Arrays.copyOf(head, headLength + other.length - from);
    System.arraycopy(other, from, bytes, headLength, other.length - from);
    return bytes;
  }

  /** Replaces a bit, a byte, or a number in either byte order. */
  private void change(byte[] bytes) {
    int at = rng.nextInt(bytes.length);
    if (rng.nextBoolean(0.3)) {
      bytes[at] ^= (byte) (1 << rng.nextInt(8));
      return;
    }
    boolean isAny = rng.nextBoolean(0.3);
    int value = isAny ? (int) rng.nextLong() : HARMFUL[rng.nextInt(HARMFUL.length)];
    int width = Math.min(1 << rng.nextInt(3), bytes.length - at);
    boolean isBigEndian = rng.nextBoolean(0.5);
    for (int i = 0; i < width; i++) {
      bytes[at + i] = (byte) (value >> (Byte.SIZE * (isBigEndian ? width - 1 - i : i)));
    }
  }

  private static void feed(byte[] input, Consumer<byte[]> target, String which) {
    byte[] asItWas = input.clone();
    try {
      target.accept(input);
    } catch (RuntimeException | StackOverflowError | AssertionError e) {
      throw new AssertionError(which + ": " + HexFormat.of().formatHex(asItWas), e);
    }
  }

  private static void keep(List<byte[]> samples) {
    String folder = System.getProperty("starl.fuzz.samples");
    if (folder == null) {
      return;
    }
    try {
      Files.createDirectories(Path.of(folder));
      for (int i = 0; i < samples.size(); i++) {
        Files.write(Path.of(folder, "sample" + i), samples.get(i));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

package org.starl.random;

/**
 * A pseudo-random generator whose numbers depend only on its seed, on every JVM: SplitMix64
 * (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", OOPSLA 2014).
 *
 * <p>{@link #fork(String)} gives an independent generator for a stable name ({@code robot7/radio}).
 * It depends only on this generator's seed and the name, not on the numbers drawn before, so an
 * additional user of random numbers changes no other user's. Not for cryptography; not thread-safe.
 */
public final class Rng {

  private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;
  private static final long FNV_OFFSET = 0xCBF29CE484222325L;
  private static final long FNV_PRIME = 0x100000001B3L;

  private final long seed;
  private final Redraw redraw;
  private long state;

  /** Lets all generators that share it draw other numbers from now on. Not thread-safe. */
  public static final class Redraw {

    private static final Redraw NEVER = new Redraw();

    private long salt;

    /**
     * From now on the generators draw as if they had another seed, which depends on their own one and
     * on {@code number}.
     */
    public void with(long number) {
      salt = new Rng(number).nextLong();
    }
  }

  public Rng(long seed) {
    this(seed, Redraw.NEVER);
  }

  /**
   * A generator which draws other numbers after {@code redraw}. Until then they are those of {@code
   * new Rng(seed)}.
   */
  public Rng(long seed, Redraw redraw) {
    this.seed = seed;
    this.redraw = redraw;
    this.state = mix(seed);
  }

  /** An independent generator for {@code name}. */
  public Rng fork(String name) {
    long hash = FNV_OFFSET;
    for (int i = 0; i < name.length(); i++) {
      hash = (hash ^ name.charAt(i)) * FNV_PRIME;
    }
    return withSeed(mix(seed + GOLDEN_GAMMA) ^ mix(hash));
  }

  /** A generator with another seed, which is drawn anew together with this one. */
  public Rng withSeed(long newSeed) {
    return new Rng(newSeed, redraw);
  }

  public long nextLong() {
    state += GOLDEN_GAMMA;
    return mix(state ^ redraw.salt);
  }

  /** Uniform in {@code [0, bound)}, without bias. */
  public int nextInt(int bound) {
    if (bound <= 0) {
      throw new IllegalArgumentException("bound " + bound + ": expected above 0");
    }
    // Lemire's method over 32 bits: unbiased, and one multiplication in nearly every case.
    long product = (nextLong() >>> 32) * bound;
    long low = product & 0xFFFFFFFFL;
    if (low < bound) {
      long threshold = (1L << 32) % bound;
      while (low < threshold) {
        product = (nextLong() >>> 32) * bound;
        low = product & 0xFFFFFFFFL;
      }
    }
    return (int) (product >>> 32);
  }

  /** Uniform in {@code [fromInclusive, toInclusive]}. */
  public long nextLong(long fromInclusive, long toInclusive) {
    if (fromInclusive > toInclusive) {
      throw new IllegalArgumentException("empty range " + fromInclusive + ".." + toInclusive);
    }
    long span = toInclusive - fromInclusive + 1;
    if (span <= 0) {
      long any;
      do {
        any = nextLong();
      } while (any < fromInclusive || any > toInclusive);
      return any;
    }
    // The largest multiple of span below 2^63; draws beyond it would favour small values.
    long limit = Long.MAX_VALUE - (Long.MAX_VALUE % span + 1) % span;
    long draw;
    do {
      draw = nextLong() >>> 1;
    } while (draw > limit);
    return fromInclusive + draw % span;
  }

  /** Uniform in {@code [0, 1)}. */
  public double nextDouble() {
    return (nextLong() >>> 11) * 0x1.0p-53;
  }

  /** True with the given probability. */
  public boolean nextBoolean(double probability) {
    return nextDouble() < probability;
  }

  /** Exponentially distributed with mean 1. */
  public double nextExponential() {
    return -StrictMath.log(1 - nextDouble());
  }

  /** Normally distributed with mean 0 and deviation 1: one value of a Box-Muller pair. */
  public double nextGaussian() {
    double radius = StrictMath.sqrt(2 * nextExponential());
    return radius * StrictMath.cos(2 * StrictMath.PI * nextDouble());
  }

  private static long mix(long z) {
    long a = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    long b = (a ^ (a >>> 27)) * 0x94D049BB133111EBL;
    return b ^ (b >>> 31);
  }
}

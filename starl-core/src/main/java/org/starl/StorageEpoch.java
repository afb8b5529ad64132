package org.starl;

import java.nio.ByteBuffer;
import java.security.SecureRandom;
import org.starl.platform.StableStorage;

/**
 * A random number that is made with a robot's stable storage, and lost with it. Other robots tell by
 * it that a robot has lost its storage, and so the promises in it; and process ids contain it, so
 * that no id of a lost storage is used again. Simulated robots, whose storage is never lost, have
 * none.
 */
public final class StorageEpoch {

  /** The epoch of a storage that has none. */
  public static final long NONE = 0;

  private static final String KEY = "starl.epoch";

  private StorageEpoch() {}

  /** The storage's epoch, or {@link #NONE}. Strand only. */
  public static long of(StableStorage stable) {
    byte[] stored = stable.get(KEY);
    return stored == null || stored.length != Long.BYTES ? NONE : ByteBuffer.wrap(stored).getLong();
  }

  /**
   * The storage's epoch, which is drawn now if it has none.
   *
   * @param stable not yet used by its strand
   */
  public static long ofOrNew(StableStorage stable, SecureRandom random) {
    long epoch = of(stable);
    while (epoch == NONE) {
      epoch = random.nextLong();
      stable.put(KEY, ByteBuffer.allocate(Long.BYTES).putLong(epoch).array(), () -> {});
    }
    return epoch;
  }
}

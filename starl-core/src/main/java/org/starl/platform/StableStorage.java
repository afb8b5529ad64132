package org.starl.platform;

import org.jspecify.annotations.Nullable;

/**
 * Stable storage: small values by key that survive a restart of the robot's program. Strand only.
 */
public interface StableStorage {

  /** A copy of the value last written under {@code key}, flushed or not, or null. */
  byte @Nullable [] get(String key);

  /**
   * Writes {@code value} and calls {@code flushed} on the strand, never inside this call, as soon
   * as the value survives a crash. A crash before that may keep the older value. Writes are flushed
   * in the order of their calls.
   */
  void put(String key, byte[] value, Runnable flushed);

  /** Removes {@code key}; a crash may restore it. */
  void remove(String key);
}

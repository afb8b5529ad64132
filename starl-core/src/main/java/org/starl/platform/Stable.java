package org.starl.platform;

import org.jspecify.annotations.Nullable;

/** A few bytes by name that survive a restart of the robot's program. Strand only. */
public interface Stable {

  /** The value last written under {@code key}, flushed or not, or null. The caller's own copy. */
  byte @Nullable [] get(String key);

  /**
   * Writes {@code value} and calls {@code flushed} on the strand, never inside this call, once it
   * would survive a crash. A crash before that may keep the older value. Writes are flushed in the
   * order in which they were made.
   */
  void put(String key, byte[] value, Runnable flushed);

  /** Forgets {@code key}; a crash may bring it back. */
  void remove(String key);
}

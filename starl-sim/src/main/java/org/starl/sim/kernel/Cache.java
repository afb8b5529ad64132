package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;

/**
 * Brings objects into the processor's cache by reading a word of each. What {@code touch} methods
 * return means nothing, but depends on what they read: somebody must keep it, or the compiler leaves
 * the reading out.
 */
public final class Cache {

  private Cache() {}

  public static int touch(@Nullable Object object) {
    // An object's class stands in its first word.
    return object != null && object.getClass() == Nothing.class ? 1 : 0;
  }

  /** Of this class there is no object. */
  private static final class Nothing {
    private Nothing() {}
  }
}

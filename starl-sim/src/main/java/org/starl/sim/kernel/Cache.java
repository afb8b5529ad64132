package org.starl.sim.kernel;

import org.jspecify.annotations.Nullable;

/**
 * Prefetches objects into the processor's cache by reading one word of each. The value that {@code
 * touch} methods return has no meaning, but depends on the words read: the caller stores it, which
 * prevents dead-code elimination.
 */
public final class Cache {

  private Cache() {}

  public static int prefetch(@Nullable Object object) {
    // The class is in an object's header.
    return object != null && object.getClass() == Nothing.class ? 1 : 0;
  }

  /** Has no instances. */
  private static final class Nothing {
    private Nothing() {}
  }
}

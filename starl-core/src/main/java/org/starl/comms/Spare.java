package org.starl.comms;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Keeps one object between uses, for every robot of the process. In a simulation, where robots run
 * one at a time, all of them use the same one: it stays in the processor's cache. Where two robots
 * need one at once, the second gets a new object. Any thread may call.
 */
final class Spare<T> {

  private final AtomicReference<@Nullable T> spare = new AtomicReference<>();
  private final Supplier<T> factory;

  Spare(Supplier<T> factory) {
    this.factory = factory;
  }

  /** An object that belongs to the caller until {@link #giveBack}; keeping it for ever is harmless. */
  T take() {
    T found = spare.getAndSet(null);
    return found == null ? factory.get() : found;
  }

  void giveBack(T object) {
    spare.lazySet(object);
  }
}

package org.starl.gvh;

import org.starl.trace.Instance;

/**
 * A single-writer, multi-reader variable of the gvh (paper, section 2): the primitive that owns it
 * writes it, the app reads it, the trace records each change. Where the paper has null or fail, the
 * type has a value of its own, never a Java null.
 */
public interface GvhVariable<T> {

  T get();

  /** The app, or the primitive's instance, as in {@code mutex/crossing}. */
  Instance source();

  /** The paper's spelling, as in {@code crit}. */
  String name();
}

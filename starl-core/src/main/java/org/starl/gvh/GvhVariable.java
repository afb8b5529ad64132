package org.starl.gvh;

/**
 * A write-one, read-many object of the gvh (paper, section 2): written by the one primitive that
 * owns it, read by the app, traced on change. What is null or fail in the paper is a value of its
 * own here, never a Java null.
 */
public interface GvhVariable<T> {

  T get();

  /** The primitive and its instance, as in {@code mutex/crossing}. */
  String source();

  /** The paper's spelling, as in {@code crit}. */
  String name();
}

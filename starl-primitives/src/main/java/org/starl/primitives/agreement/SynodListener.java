package org.starl.primitives.agreement;

/** Whoever stands on a {@link Synod}: hears what is decided. */
public interface SynodListener {

  /**
   * This robot's proposal has been decided, and nobody else may know: tell everybody who should.
   * Comes just before {@link #learned}.
   */
  void chosen(long number, Value value);

  /** A decree above all that were known before; numbers between may have been skipped. */
  void learned(long number, Value value);

  /** Somebody works for a number that is not known to be decided; a hint, of use to some. */
  default void rumour(long number) {}
}

package org.starl.primitives.agreement;

/** Hears what a {@link Synod} decides. */
public interface SynodListener {

  /**
   * This robot's proposal is decided. Perhaps no other robot knows: tell all that should. Called just
   * before {@link #learned}.
   */
  void chosen(long number, Value value);

  /** The latest decree is now {@code number}; lower numbers may have been skipped. */
  void learned(long number, Value value);

  /** A hint: a robot proposes for a number that is not known to be decided. */
  default void rumour(long number) {}
}

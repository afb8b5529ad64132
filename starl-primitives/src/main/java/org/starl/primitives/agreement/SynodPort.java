package org.starl.primitives.agreement;

import org.starl.RobotId;

/** Where a {@link Synod}'s effects go. */
public interface SynodPort {

  /** Sends, best effort; to this robot itself as well. */
  void send(RobotId to, SynodMessage message);

  /**
   * Writes the acceptor's {@code record} in place of the one before, and calls {@link
   * Synod#flushed} with {@code version}, later, once it would survive a crash. Writes are flushed in
   * order.
   */
  void persist(long version, byte[] record);

  /**
   * This robot's proposal has been decided, and nobody else may know: tell everybody who should.
   * Comes just before {@link #learned}.
   */
  void chosen(long number, Value value);

  /** A decree above all that were known before; numbers between may have been skipped. */
  void learned(long number, Value value);

  /** Somebody works for a number that is not known to be decided. */
  void rumour(long number);
}

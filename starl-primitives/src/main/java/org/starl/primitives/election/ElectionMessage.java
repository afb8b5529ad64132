package org.starl.primitives.election;

import org.starl.id.ProcessId;

/** The election's own messages. All are idempotent. */
sealed interface ElectionMessage {

  /** An id of the sender. */
  ProcessId from();

  /** The term, from 1. */
  long term();

  /**
   * {@code from} may be elected in {@code term}.
   *
   * @param draw its random number in this term
   */
  record Candidacy(ProcessId from, long term, long draw) implements ElectionMessage {}

  /** {@code leader} is decided for {@code term}. */
  record Elected(ProcessId from, long term, ProcessId leader) implements ElectionMessage {}
}

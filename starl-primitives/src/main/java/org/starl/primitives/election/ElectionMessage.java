package org.starl.primitives.election;

import org.starl.id.ProcessId;

/** The election's own messages, beside the Synod's. All are idempotent. */
sealed interface ElectionMessage {

  /** Who says so: one of the sender's ids. */
  ProcessId from();

  /** The term that this is about, from 1. */
  long term();

  /**
   * {@code from} may be elected in {@code term}.
   *
   * @param draw its lot in this term
   */
  record Candidacy(ProcessId from, long term, long draw) implements ElectionMessage {}

  /** {@code leader} is decided for {@code term}. */
  record Elected(ProcessId from, long term, ProcessId leader) implements ElectionMessage {}
}

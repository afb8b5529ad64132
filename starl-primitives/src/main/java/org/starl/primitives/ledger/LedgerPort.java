package org.starl.primitives.ledger;

import java.util.List;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Value;

/** The effects of a {@link LedgerProtocol}, beside those of its Synod. */
interface LedgerPort {

  /** Sends, best effort. */
  void send(RobotId to, LedgerMessage message);

  /** Sends until it is handled or given up. */
  void sendReliably(RobotId to, LedgerMessage message);

  /** The state that was stored last; the empty one if there is none. */
  LedgerState stored();

  /** Stores the state; writes of this robot are flushed in order. */
  void store(LedgerState state);

  /**
   * The state has another decree.
   *
   * @param entries of the decree that took effect
   */
  void applied(long number, List<LedgerEntry> entries, int tasks);

  /** The state was taken over from storage, or from another robot. */
  void installed(long number, int tasks);

  /** Throws an exception if the app cannot read what is to be done. */
  void check(Value what);

  /** Messages of a process made no sense together, and were dropped. */
  void refused(ProcessId from, String what);

  /** A call of the app is settled. */
  void told(LedgerEntry entry, LedgerOutcome outcome);
}

package org.starl.primitives.ledger;

import org.starl.primitives.agreement.SynodTiming;

/**
 * Times of a ledger. Safety does not depend on them.
 *
 * @param timing the waits of proposers
 * @param beaconMs each robot tells the voters with this period that it lives, in ms
 * @param leaseMs a claim ends, unless it is begun, once a voter has heard nothing of its robot for this
 *     time, in ms; a short time frees tasks of slow robots, a long one makes tasks wait
 * @param deadlineMs a call is given up after this time, in ms, as UNKNOWN
 */
public record LedgerSettings(SynodTiming timing, long beaconMs, long leaseMs, long deadlineMs) {

  public static final LedgerSettings DEFAULT =
      new LedgerSettings(SynodTiming.DEFAULT, 2_000, 8_000, 30_000);

  public LedgerSettings {
    if (beaconMs <= 0 || leaseMs <= beaconMs || deadlineMs <= 0) {
      throw new IllegalArgumentException(
          "ledger: expected times above 0, and the lease above the beacon");
    }
  }

  public LedgerSettings withDeadlineMs(long newDeadlineMs) {
    return new LedgerSettings(timing, beaconMs, leaseMs, newDeadlineMs);
  }
}

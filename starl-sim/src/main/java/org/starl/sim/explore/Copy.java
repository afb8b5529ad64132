package org.starl.sim.explore;

import org.starl.input.Quantities;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;

/**
 * One copy of a datagram in a run.
 *
 * @param datagram its number among the sender's datagrams
 * @param arrivesAtNs {@link #NEVER} if it was lost
 */
public record Copy(String from, String to, long datagram, long sentAtNs, long arrivesAtNs) {

  /** The arrival of a lost copy. */
  static final long NEVER = Long.MAX_VALUE;

  boolean isLost() {
    return arrivesAtNs == NEVER;
  }

  Fault arrivingAt(long timeNs) {
    return fault(Quantities.durationText(timeNs - sentAtNs));
  }

  Fault lost() {
    return fault("lost");
  }

  private Fault fault(String fate) {
    return FaultGrammar.parse("datagram(%s>%s,%d,%s)".formatted(from, to, datagram, fate));
  }
}

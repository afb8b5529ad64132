package org.starl.workload;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.comms.DropReason;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Fault;

/**
 * {@code WellFormed}: until an attacker appears, no robot drops a datagram that correct robots never
 * send, such as one that its channel's codec does not read back.
 */
final class WellFormedSpec extends LemmaMonitor {

  private static final String WELL_FORMED = "datagrams.WellFormed";

  private static final Set<String> ATTACKS = Set.of("forge", "replay", "flood");

  private final Set<String> suspicious = new TreeSet<>();
  private boolean isAttacked;

  WellFormedSpec() {
    lemma(WELL_FORMED, "Without an attacker, every datagram can be read.");
    for (DropReason reason : DropReason.values()) {
      if (reason.isSuspicious()) {
        suspicious.add(reason.toString());
      }
    }
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (event instanceof Fault fault) {
      isAttacked |= ATTACKS.contains(fault.effect());
    } else if (event instanceof Delivered && !isAttacked) {
      report.checked(WELL_FORMED);
    } else if (event instanceof Dropped dropped && !isAttacked) {
      report.checked(WELL_FORMED);
      if (suspicious.contains(dropped.why())) {
        String detail = "drops a datagram of " + dropped.from() + ": " + dropped.why();
        report.violated(WELL_FORMED, dropped.timeNs(), List.of(dropped.robot()), detail);
      }
    }
  }
}

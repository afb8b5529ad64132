package org.starl.sim.fault;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.trace.TraceEvent;

/** The faults of one run: begins and ends them, and records both in the trace. */
public final class FaultRun {

  private final FaultTarget ward;
  private int faults;
  private int toEnd;

  FaultRun(FaultTarget ward) {
    this.ward = ward;
  }

  /**
   * Adds faults. Due faults begin now.
   *
   * @param rng for these faults only
   */
  public void add(FaultPlan plan, Rng rng) {
    Map<String, Integer> sameBefore = new LinkedHashMap<>();
    List<Fault> more = plan.faults();
    int before = faults;
    faults += more.size();
    toEnd += more.size();
    for (int i = 0; i < more.size(); i++) {
      Fault fault = more.get(i);
      // Forked by text and, for equal faults, by count: a fault does not change another's random
      // numbers.
      int copy = sameBefore.merge(fault.toString(), 1, Integer::sum);
      Rng own = rng.fork(fault + "#" + copy);
      long beginNs = fault.span().at().drawNs(own.fork("at"));
      int number = before + i;
      if (beginNs <= ward.nowNs()) {
        begin(fault, number, own);
      } else {
        ward.at(beginNs, () -> begin(fault, number, own));
      }
    }
  }

  private void begin(Fault fault, int number, Rng rng) {
    FaultEffect harm = fault.effect();
    Runnable cure;
    List<RobotId> whom;
    long lastingNs = fault.span().drawLastingNs(ward.nowNs(), rng.fork("for"));
    try {
      whom = harm.who().pick(ward, rng.fork("who"));
      tell(fault, whom, TraceEvent.Fault.BEGIN);
      cure = harm.begin(new FaultContext(ward, number, whom, lastingNs, rng));
    } catch (BadInput wrong) {
      throw Quantities.in(BadInput.quote(fault.toString()), wrong);
    }
    if (lastingNs != Span.NEVER) {
      ward.at(ward.nowNs() + lastingNs, () -> end(fault, whom, cure));
    } else if (fault.isFinite()) {
      end(fault, whom, cure);
    }
  }

  private void end(Fault fault, List<RobotId> whom, Runnable cure) {
    cure.run();
    tell(fault, whom, TraceEvent.Fault.END);
    toEnd--;
    if (toEnd == 0) {
      ward.recordFault(TraceEvent.Fault.WORLD, TraceEvent.Fault.HEALED, "");
    }
  }

  private void tell(Fault fault, List<RobotId> whom, String name) {
    boolean isOne = !fault.effect().who().isAll() && whom.size() == 1;
    ward.recordFault(isOne ? whom.get(0) : TraceEvent.Fault.WORLD, name, fault.toString());
  }
}

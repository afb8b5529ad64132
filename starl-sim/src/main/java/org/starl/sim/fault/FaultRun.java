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

  private final FaultTarget target;
  private int faults;
  private int toEnd;

  FaultRun(FaultTarget target) {
    this.target = target;
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
      if (beginNs <= target.nowNs()) {
        begin(fault, number, own);
      } else {
        target.at(beginNs, () -> begin(fault, number, own));
      }
    }
  }

  private void begin(Fault fault, int number, Rng rng) {
    FaultEffect effect = fault.effect();
    Runnable end;
    List<RobotId> robots;
    long lastingNs = fault.span().drawLastingNs(target.nowNs(), rng.fork("for"));
    try {
      robots = effect.robots().pick(target, rng.fork("who"));
      record(fault, robots, TraceEvent.Fault.BEGIN);
      end =
          effect
              .action()
              .begin(new FaultContext(target, number, effect.robots(), robots, lastingNs, rng));
    } catch (BadInput wrong) {
      throw Quantities.in(BadInput.quote(fault.toString()), wrong);
    }
    if (lastingNs != Span.NEVER) {
      target.at(target.nowNs() + lastingNs, () -> end(fault, robots, end));
    } else if (fault.isFinite()) {
      end(fault, robots, end);
    }
  }

  private void end(Fault fault, List<RobotId> robots, Runnable end) {
    end.run();
    record(fault, robots, TraceEvent.Fault.END);
    toEnd--;
    if (toEnd == 0) {
      target.recordFault(TraceEvent.Fault.WORLD, TraceEvent.Fault.HEALED, "", "");
    }
  }

  private void record(Fault fault, List<RobotId> robots, String name) {
    boolean isOne = !fault.effect().robots().isAll() && robots.size() == 1;
    target.recordFault(
        isOne ? robots.get(0) : TraceEvent.Fault.WORLD,
        name,
        fault.effect().name(),
        fault.toString());
  }
}

package org.starl.sim;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;
import org.starl.sim.fault.FaultPlan;
import org.starl.sim.fault.FaultRun;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Intervention;

/** Applies interventions to one run of the engine. */
final class EngineController implements RunController {

  private final Engine engine;
  private final FaultRun faults;
  private final Rng rng;
  private int done;
  private boolean isStopped;

  /**
   * @param rng generator of the behaviour seed, forked for interventions
   */
  EngineController(Engine engine, FaultRun faults, Rng rng) {
    this.engine = engine;
    this.faults = faults;
    this.rng = rng;
  }

  @Override
  public long nowNs() {
    return engine.nowNs();
  }

  @Override
  public long steps() {
    return engine.events();
  }

  @Override
  public void fault(String text) {
    Fault fault = FaultGrammar.parse(text);
    FaultPlan plan = new FaultPlan(List.of(fault));
    plan.requireNamedAmong(engine.known());
    if (fault.span().untilNs() <= nowNs()) {
      throw new BadInput(
          BadInput.quote(text) + ": ends before the present time; expected a later end");
    }
    record(TraceEvent.Fault.WORLD, Intervention.FAULT, fault.toString());
    faults.add(plan, rng.fork(Integer.toString(done)));
  }

  @Override
  public void point(RobotId robot, int xMm, int yMm) {
    if (!engine.known().contains(robot)) {
      throw new BadInput("no robot is called " + robot + "; there are " + engine.robots());
    }
    record(robot, Intervention.POINT, xMm + "," + yMm);
    engine.point(robot, xMm, yMm);
  }

  @Override
  public void stop() {
    record(TraceEvent.Fault.WORLD, Intervention.STOP, "");
    isStopped = true;
  }

  boolean isStopped() {
    return isStopped;
  }

  private void record(RobotId robot, String name, String detail) {
    if (isStopped) {
      throw new IllegalStateException("the run was stopped");
    }
    done++;
    if (engine.observers().isOn()) {
      engine.observers().record(new Intervention(nowNs(), robot, steps(), name, detail));
    }
  }
}

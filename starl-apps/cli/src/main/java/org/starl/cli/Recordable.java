package org.starl.cli;

import java.util.List;
import java.util.function.Function;
import org.starl.apps.Plan;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;

/**
 * A run to record: a simulation, or a trace.
 *
 * @param plan of the run, with the obstacles and the layer for its pictures
 * @param show shows the run to an observer; call once
 * @param replay the command line that shows the run again
 */
record Recordable(
    String app, long seed, Plan plan, Function<SimObserver, SimResult> show, String replay) {

  /** A run that is simulated when it is shown. */
  static Recordable of(String app, long seed, Plan plan, String replay) {
    return new Recordable(
        app, seed, plan, observer -> plan.simulation().observer(observer).build().run(), replay);
  }

  /** A run in a trace. The trace must be complete, so that no file of a broken trace is written. */
  static Recordable of(TraceFile trace) {
    trace.requireWhole();
    return new Recordable(
        trace.header().scenario(),
        trace.header().scenarioSeed(),
        trace.plan(),
        observer -> trace.show(List.of(observer)),
        Shell.starl(List.of("replay", trace.name(), "--headless")));
  }
}

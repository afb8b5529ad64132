package org.starl.cli;

import java.util.List;
import java.util.function.Function;
import org.starl.apps.Plan;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;

/**
 * A run that can be recorded: one that is yet to take place, or one in a trace.
 *
 * @param plan of it; what is painted into its pictures
 * @param show lets it pass before an observer, once
 * @param again the command line that shows it again
 */
record Recordable(
    String app, long seed, Plan plan, Function<SimObserver, SimResult> show, String again) {

  /** One that is simulated when it is shown. */
  static Recordable of(String app, long seed, Plan plan, String again) {
    return new Recordable(
        app, seed, plan, observer -> plan.simulation().observer(observer).build().run(), again);
  }

  /** One that is whole: nothing is written of a trace that ends in an error. */
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

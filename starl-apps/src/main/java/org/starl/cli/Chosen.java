package org.starl.cli;

import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.sim.SimSettings;

/**
 * What to run, once names, files and flags are understood.
 *
 * @param parameters of the app, every one of them
 * @param settings the user's, by key, over the app's defaults
 */
record Chosen(
    Demo demo,
    OptionalInt robots,
    SortedMap<String, String> parameters,
    Map<String, String> settings) {

  /**
   * The simulation of one seed, a fresh one at each call.
   *
   * @throws org.starl.sim.input.BadInput if a value cannot be used
   */
  Plan plan(long seed) {
    Request request = new Request(seed, robots, parameters);
    SimSettings.Builder builder = demo.defaultSettings(request);
    settings.forEach(builder::set);
    Plan plan = demo.plan(request, builder.build());
    plan.simulation().name(demo.name()).seed(seed);
    parameters.forEach(plan.simulation()::parameter);
    return plan;
  }
}

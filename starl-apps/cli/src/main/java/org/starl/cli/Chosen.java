package org.starl.cli;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.fault.FaultPlan;

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

  /** How long a run may take where neither the user nor the app says so. */
  private static final Duration LONGEST = Duration.ofMinutes(20);

  /** These parameters and settings; among the settings may be the number of robots. */
  static Chosen of(Demo demo, SortedMap<String, String> parameters, Map<String, String> settings) {
    String robots = settings.get(Setting.ROBOTS.key());
    return new Chosen(
        demo,
        robots == null ? OptionalInt.empty() : OptionalInt.of(Integer.parseInt(robots)),
        parameters,
        settings);
  }

  /**
   * The simulation of one seed, a fresh one at each call.
   *
   * @throws org.starl.input.BadInput if a value cannot be used
   */
  Plan plan(long seed) {
    Request request = new Request(seed, robots, parameters);
    SimSettings.Builder builder = demo.defaultSettings(request);
    if (builder.build().get(Setting.DURATION).isZero()) {
      builder.set(Setting.DURATION, LONGEST);
    }
    settings.forEach(builder::set);
    Plan plan = demo.plan(request, builder.build());
    plan.simulation().name(demo.name()).seed(seed);
    parameters.forEach(plan.simulation()::parameter);
    if (robots.isEmpty()) {
      plan.simulation().countedByScenario();
    }
    return plan;
  }

  /** The words that run one seed of it, after {@code ./starl}. */
  List<String> words(String command, long seed) {
    List<String> words = new ArrayList<>(List.of(command, demo.name()));
    words.addAll(List.of("--seed", Long.toString(seed)));
    Map<String, String> sets = new LinkedHashMap<>(settings);
    option(words, "--robots", sets.remove(Setting.ROBOTS.key()));
    option(words, "--for", sets.remove(Setting.DURATION.key()));
    FaultPlan.parse(sets.getOrDefault(Setting.FAULTS.key(), ""))
        .faults()
        .forEach(fault -> option(words, "--fault", fault.toString()));
    sets.remove(Setting.FAULTS.key());
    for (Parameter parameter : demo.parameters()) {
      String value = parameters.get(parameter.key());
      if (!parameter.defaultValue().equals(value)) {
        option(words, "--set", parameter.key() + "=" + value);
      }
    }
    sets.forEach((key, value) -> option(words, "--set", key + "=" + value));
    return words;
  }

  private static void option(List<String> words, String option, @Nullable String value) {
    if (value != null) {
      words.addAll(List.of(option, value));
    }
  }
}

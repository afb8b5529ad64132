package org.starl.apps.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;

/** Runs whole searches: all specifications must hold, and all robots end with one answer. */
final class Searches {

  private Searches() {}

  private static final SearchDemo DEMO = new SearchDemo();

  static Plan plan(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    SortedMap<String, String> all = DEMO.defaults();
    all.putAll(parameters);
    OptionalInt count = robots == 0 ? OptionalInt.empty() : OptionalInt.of(robots);
    Request request = new Request(seed, count, all);
    SimSettings.Builder builder = DEMO.defaultSettings(request);
    settings.forEach(builder::set);
    Plan plan = DEMO.plan(request, builder.build());
    plan.simulation().name("search").seed(seed);
    return plan;
  }

  /** Runs a search and returns the answer of all robots. */
  static String answer(Plan plan) {
    SimResult result = plan.simulation().build().run();
    String story = "seed " + result.seed() + "\n" + String.join("\n", plan.story().lines());
    assertThat(result.spec().violations()).as(story).isEmpty();
    assertThat(result.unfinished()).as(story).isEmpty();
    var answers = new HashSet<String>();
    result.results().values().forEach(ended -> answers.add(ended.get(0).toString()));
    assertThat(answers).as(story).hasSize(1);
    return answers.iterator().next();
  }

  static Path originals() {
    String shared = System.getProperty("starl.shared", "../../shared");
    Path folder = Path.of(shared, "data", "starl-original", "search");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (set -Dstarl.shared)");
    return folder;
  }
}

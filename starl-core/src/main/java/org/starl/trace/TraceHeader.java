package org.starl.trace;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * The first line of a trace: all that it takes to run the same again.
 *
 * @param starl the version of StarL that ran
 * @param scenario the app's or scenario's name, or its file
 * @param scenarioSeed decides the scenario: starts, routes, arrivals, obstacles
 * @param behaviourSeed decides everything else: delays, losses, noise, what robots draw
 * @param settings the app's parameters and the settings, in the order to show them; without the number
 *     of robots where the scenario decided it
 * @param robots the robots of the deployment, in order; others may join during the run
 */
public record TraceHeader(
    String starl,
    String scenario,
    long scenarioSeed,
    long behaviourSeed,
    Map<String, String> settings,
    List<RobotId> robots) {

  /** The version of the lines' format; a reader takes no other. */
  public static final int FORMAT = 1;

  /** The behaviour's seed where only the scenario's is given. */
  public static long behaviourSeedOf(long scenarioSeed) {
    return new Rng(scenarioSeed).fork("behaviour").nextLong();
  }

  public TraceHeader {
    settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
    robots = List.copyOf(robots);
  }
}

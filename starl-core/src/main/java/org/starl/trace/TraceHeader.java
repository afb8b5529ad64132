package org.starl.trace;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * The first line of a trace: everything needed to repeat the run.
 *
 * @param starl StarL's version
 * @param scenario name of the app or scenario, or the scenario's file
 * @param scenarioSeed determines the scenario: starts, routes, arrivals, obstacles
 * @param behaviourSeed determines everything else: delays, losses, noise, the robots' random
 *     numbers
 * @param settings the app's parameters and the settings, in the order to show them; without the
 *     number of robots if the scenario determines it
 * @param robots the robots of the deployment, in order; others may join during the run
 */
public record TraceHeader(
    String starl,
    String scenario,
    long scenarioSeed,
    long behaviourSeed,
    Map<String, String> settings,
    List<RobotId> robots) {

  /** The version of the format; a reader accepts only this one. */
  public static final int FORMAT = 3;

  /** The behaviour seed used when only the scenario seed is given. */
  public static long behaviourSeedOf(long scenarioSeed) {
    return new Rng(scenarioSeed).fork("behaviour").nextLong();
  }

  public TraceHeader {
    settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
    robots = List.copyOf(robots);
  }
}

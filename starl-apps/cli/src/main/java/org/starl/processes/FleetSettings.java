package org.starl.processes;

import java.time.Duration;
import java.util.List;

/**
 * How a fleet runs.
 *
 * @param rounds how often each robot's app runs, from 1
 * @param kills processes to end as {@code kill -9} does
 * @param limit the fleet is stopped after this time
 * @param quiet once a process is gone, the fleet is stopped when nobody has told anything new for so
 *     long: those who are left wait for what the dead one holds
 */
public record FleetSettings(int rounds, List<Kill> kills, Duration limit, Duration quiet) {

  /** Longer than it takes to suspect a dead robot, and to agree on it. */
  public static final Duration USUAL_QUIET = Duration.ofSeconds(30);

  public FleetSettings {
    kills = List.copyOf(kills);
    if (rounds < 1 || limit.isNegative() || limit.isZero() || quiet.isNegative()) {
      throw new IllegalArgumentException("expected rounds from 1, times above 0");
    }
  }

  /** Each app once, nobody killed. */
  public static FleetSettings within(Duration limit) {
    return new FleetSettings(1, List.of(), limit, USUAL_QUIET);
  }

  public FleetSettings withRounds(int newRounds) {
    return new FleetSettings(newRounds, kills, limit, quiet);
  }

  public FleetSettings withKills(List<Kill> newKills) {
    return new FleetSettings(rounds, newKills, limit, quiet);
  }
}

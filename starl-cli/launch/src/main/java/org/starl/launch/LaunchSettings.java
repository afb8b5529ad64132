package org.starl.launch;

import java.time.Duration;
import java.util.List;

/**
 * Settings of a {@link Launcher}.
 *
 * @param rounds number of times that each robot runs its app, from 1
 * @param kills processes to kill
 * @param limit longest time of the run
 * @param quiet after a death, the run ends after this time without progress: the other robots then
 *     wait for sections that the dead robot may hold
 */
public record LaunchSettings(int rounds, List<Kill> kills, Duration limit, Duration quiet) {

  /** Longer than the primitives need to suspect a dead robot and to agree on that. */
  public static final Duration DEFAULT_QUIET = Duration.ofSeconds(30);

  public LaunchSettings {
    kills = List.copyOf(kills);
    if (rounds < 1 || limit.isNegative() || limit.isZero() || quiet.isNegative()) {
      throw new IllegalArgumentException("expected rounds from 1, times above 0");
    }
  }
}

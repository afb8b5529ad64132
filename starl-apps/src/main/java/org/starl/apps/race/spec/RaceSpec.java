package org.starl.apps.race.spec;

import java.util.List;
import java.util.function.Supplier;
import org.starl.apps.race.logic.RacePoint;
import org.starl.spec.Monitor;

/** Everything that is checked of a race itself. */
public final class RaceSpec {

  private RaceSpec() {}

  /** Monitors' makers, as each run needs its own. */
  public static List<Supplier<? extends Monitor>> of(List<RacePoint> points, RaceBounds bounds) {
    return List.of(() -> new RaceSafety(points), () -> new RaceProgress(points, bounds));
  }
}

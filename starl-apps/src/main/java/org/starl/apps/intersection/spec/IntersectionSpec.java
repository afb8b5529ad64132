package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.starl.RobotId;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.spec.Monitor;

/** Everything that is checked in a run of the intersection. */
public final class IntersectionSpec {

  private IntersectionSpec() {}

  /**
   * Monitors' makers, as each run needs its own.
   *
   * @param paths the zones of each car's trip, in order; none for a parked car
   */
  public static List<Supplier<? extends Monitor>> of(
      String xid, Crossing crossing, Map<RobotId, List<String>> paths) {
    List<Supplier<? extends Monitor>> monitors = new ArrayList<>();
    monitors.add(() -> new TrafficSafety(crossing.regions()));
    monitors.add(MuxSafety::new);
    monitors.add(() -> new ListCrit(paths));
    monitors.add(() -> new TrafficProgress(paths.size()));
    monitors.add(() -> new MutexSpec(xid));
    monitors.add(RegistrationSpec::new);
    return monitors;
  }
}

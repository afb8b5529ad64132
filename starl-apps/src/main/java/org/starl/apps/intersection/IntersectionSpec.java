package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.starl.RobotId;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.spec.Monitor;

/** Everything that is checked in a run of the intersection. */
final class IntersectionSpec {

  private IntersectionSpec() {}

  /** Monitors' makers, as each run needs its own. */
  static List<Supplier<? extends Monitor>> of(String xid, Crossing crossing, List<Car> cars) {
    SortedMap<RobotId, List<String>> paths = new TreeMap<>();
    for (Car car : cars) {
      List<String> path = new ArrayList<>();
      car.trip().stations().forEach(station -> path.add(station.name()));
      paths.put(car.id(), List.copyOf(path));
    }
    List<Supplier<? extends Monitor>> monitors = new ArrayList<>();
    monitors.add(() -> new TrafficSafety(crossing.regions()));
    monitors.add(MuxSafety::new);
    monitors.add(() -> new ListCrit(paths));
    monitors.add(() -> new TrafficProgress(cars.size()));
    monitors.add(() -> new MutexSpec(xid));
    monitors.add(RegistrationSpec::new);
    return monitors;
  }
}

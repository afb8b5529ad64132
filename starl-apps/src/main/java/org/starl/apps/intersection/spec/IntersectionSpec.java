package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Lane;
import org.starl.geometry.Rectangle;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.spec.Monitor;

/** All specifications of the intersection. */
public final class IntersectionSpec {

  private IntersectionSpec() {}

  /** Creates the monitors of one run each. */
  public static List<Supplier<? extends Monitor>> of(String xid, Bounds bounds) {
    SortedMap<String, Rectangle> zones = Crossing.regions(bounds.places());
    List<Supplier<? extends Monitor>> monitors = new ArrayList<>();
    monitors.add(() -> new TrafficSafety(zones));
    monitors.add(MuxSafety::new);
    monitors.add(() -> new ListCrit(xid));
    monitors.add(() -> new TrafficProgress(bounds.trafficNs()));
    monitors.add(() -> new MutexSpec(xid, bounds.zones()));
    monitors.add(RegistrationSpec::new);
    for (int rank = 0; rank < bounds.places(); rank++) {
      String instance = Lane.instance(xid, rank);
      monitors.add(() -> new MutexSpec(instance, bounds.queue()));
    }
    return monitors;
  }
}

package org.starl.apps.intersection.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.gvh.GvhCell;

/** How one car appears in a trace. Strand only. */
public final class CrossingTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Action at the start of the program: the trip's label, and the zones ahead as a list. */
  public static final String TRIP = "trip";

  /** Variable: the {@link IntersectionApp.Location}. */
  public static final String LOCATION = "location";

  /** Variable: the zones that still lie ahead, as a list. */
  public static final String MYSEQ = "myseq";

  private final GlobalVarHolder gvh;
  private final GvhCell<IntersectionApp.Location> location;
  private final GvhCell<List<String>> myseq;

  /** Tells the trip, and that all of it lies ahead. */
  CrossingTrace(GlobalVarHolder gvh, Trip trip, IntersectionApp.Location start) {
    this.gvh = gvh;
    trip(trip.label(), trip.zones());
    location = gvh.variable(SOURCE, LOCATION, start);
    myseq = gvh.variable(SOURCE, MYSEQ, trip.zones());
  }

  GvhCell<IntersectionApp.Location> location() {
    return location;
  }

  void trip(String label, List<String> zones) {
    gvh.trace.action(SOURCE, TRIP, label, zones);
  }

  void myseq(List<String> zones) {
    myseq.set(zones);
  }
}

package org.starl.apps.intersection.logic;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.trace.MessageText;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** How one car appears in a trace: the words that the program writes and observers read. */
public final class CrossingTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Action at the start of the program: the trip's label, and the zones ahead as a list. */
  public static final String TRIP = "trip";

  /** Variable: the {@link Location}. */
  public static final String LOCATION = "location";

  /** Variable: the zones that still lie ahead, as a list. */
  public static final String MYSEQ = "myseq";

  // Where the names of IcpProgram, which are Figure 3's, differ from those of IntersectionApp. At
  // S0 a
  // restarted program finds out what lies ahead, as IntersectionApp does in RESUME.
  private static final Map<String, Location> FIGURE_3 =
      Map.of(
          "S0",
          Location.RESUME,
          "REG_WAIT",
          Location.REGISTER_WAIT,
          "S1",
          Location.S_1,
          "UNREG_WAIT",
          Location.UNREGISTER_WAIT);

  private CrossingTrace() {}

  /** The action {@link #TRIP}. */
  public record TripEvent(String label, List<String> zones) {}

  /** The event as a trip, if it is one. */
  public static Optional<TripEvent> trip(TraceEvent event) {
    return event instanceof Action action
            && action.source().equals(SOURCE)
            && action.name().equals(TRIP)
        ? Optional.of(new TripEvent(action.args().get(0), MessageText.parts(action.args().get(1))))
        : Optional.empty();
  }

  /** The location that the event's robot has now, if the event changes it. */
  public static Optional<Location> location(TraceEvent event) {
    return variable(event, LOCATION)
        .map(name -> FIGURE_3.containsKey(name) ? FIGURE_3.get(name) : Location.valueOf(name));
  }

  /** The new {@link #MYSEQ} of the event's robot, if the event changes it. */
  public static Optional<List<String>> myseq(TraceEvent event) {
    return variable(event, MYSEQ).map(MessageText::parts);
  }

  private static Optional<String> variable(TraceEvent event, String name) {
    return event instanceof Variable variable
            && variable.source().equals(SOURCE)
            && variable.name().equals(name)
        ? Optional.of(variable.value())
        : Optional.empty();
  }

  /** Whether the event's robot was stopped on its way: a bump, no fix, stuck wheels. */
  public static boolean isStopped(TraceEvent event) {
    return event instanceof Variable variable
        && variable.name().equals("motionflag")
        && variable.value().equals("FAIL");
  }
}

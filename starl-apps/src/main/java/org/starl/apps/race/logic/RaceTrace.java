package org.starl.apps.race.logic;

import java.util.Optional;
import org.starl.GlobalVarHolder;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** The names of a race's events in the trace. */
public final class RaceTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link RaceApp.Location}. */
  public static final String LOCATION = "location";

  /** Variable: the name of the point to which the robot races; empty if there is none. */
  public static final String POINT = "point";

  /**
   * Action: the robot has arrived at a point. Arguments: the point's number and name, the robot's
   * distance from it in mm, the error bound of that, and the distance from which it may win.
   */
  public static final String ARRIVE = "arrive";

  /**
   * Action: the robot knows a (better) claim. Arguments: the point's number and name, the winner,
   * its time and how far it was kept off.
   */
  public static final String TAKEN = "taken";

  private RaceTrace() {}

  /** Whether it is this app's action of that name. */
  public static boolean is(Action action, String name) {
    return action.source().equals(SOURCE) && action.name().equals(name);
  }

  /** Whether it is this app's variable of that name. */
  public static boolean is(Variable variable, String name) {
    return variable.source().equals(SOURCE) && variable.name().equals(name);
  }

  /** The claim of a {@link #TAKEN}, if the event is one. */
  public static Optional<Claim> taken(TraceEvent event) {
    return event instanceof Action action && is(action, TAKEN)
        ? Optional.of(
            new Claim(
                Integer.parseInt(action.args().get(0)),
                new RobotId(action.args().get(2)),
                Long.parseLong(action.args().get(3)),
                Integer.parseInt(action.args().get(4))))
        : Optional.empty();
  }

  static void taken(GlobalVarHolder gvh, Claim claim, RacePoint point) {
    gvh.trace.action(
        SOURCE,
        TAKEN,
        claim.point(),
        point.name(),
        claim.winner(),
        claim.atNs(),
        claim.keptOffMm());
  }
}

package org.starl.primitives.geocast;

import java.util.List;
import org.starl.primitives.Phases;

/** The names of geocasts in the trace; {@link GeocastSpec} reads them. */
public final class GeocastTrace {

  static final String GEOCAST = "geocast";
  static final String BROADCAST = "broadcast";

  /** Action with the robot's origin: it takes part from now on, and has delivered nothing. */
  static final String OPEN = "open";

  /** Action with id, area and d in ns: a geocast starts. */
  static final String DO_GEOCAST = "do_geocast";

  /** Like {@link #DO_GEOCAST}, for a broadcast. */
  static final String B_CAST = "BCast";

  /** Action with id: the robot's next broadcast datagram is a copy. */
  static final String COPY = "copy";

  /** Action with id: the app receives the message. */
  static final String DELIVER = "deliver";

  /** Action with id, reason and position error in mm: an arrived copy is not delivered. */
  static final String DISMISS = "dismiss";

  static final String GCASTFLAG = "Gcastflag";

  private static final String IDLE = "IDLE";
  private static final String CASTING = "CASTING";

  /** The phases: whether the sending of a message of this robot is incomplete. */
  public static final Phases PHASES =
      Phases.of(GEOCAST, GeocastMessage.class, () -> GeocastTrace::phase, IDLE, CASTING);

  /** As {@link #PHASES}, for broadcasts. */
  public static final Phases BROADCAST_PHASES =
      Phases.of(BROADCAST, GeocastMessage.class, () -> GeocastTrace::phase, IDLE, CASTING);

  private GeocastTrace() {}

  private static String phase(String before, String name, List<String> texts) {
    return switch (name) {
      case DO_GEOCAST, B_CAST -> CASTING;
      case GCASTFLAG -> texts.get(0).equals("true") ? IDLE : before;
      default -> before;
    };
  }

  /** Whether {@code source} is a geocast or a broadcast, as in {@code geocast/alarm}. */
  static boolean isGeocast(String source) {
    return source.startsWith(GEOCAST + "/") || source.startsWith(BROADCAST + "/");
  }
}

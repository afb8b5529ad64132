package org.starl.primitives.geocast;

/** The names under which geocasts appear in a trace; {@link GeocastSpec} decides from these. */
final class GeocastTrace {

  static final String GEOCAST = "geocast";
  static final String BROADCAST = "broadcast";

  /** Action with this robot's origin: it takes part from now on, having delivered nothing. */
  static final String OPEN = "open";

  /** Action with id, area and d in ns: a geocast starts. */
  static final String DO_GEOCAST = "do_geocast";

  /** As {@link #DO_GEOCAST}, of a broadcast. */
  static final String B_CAST = "BCast";

  /** Action with id: the next datagram to everyone is a copy of it. */
  static final String COPY = "copy";

  /** Action with id: the app is handed the message. */
  static final String DELIVER = "deliver";

  /** Action with id, reason and position error in mm: a copy came, and is not delivered. */
  static final String DISMISS = "dismiss";

  /** The reason of a dismissal that proves the clocks wrong. */
  static final String EARLY = "early";

  static final String GCASTFLAG = "Gcastflag";

  private GeocastTrace() {}

  /** Whether {@code source} is a geocast or a broadcast, as in {@code geocast/alarm}. */
  static boolean isGeocast(String source) {
    return source.startsWith(GEOCAST + "/") || source.startsWith(BROADCAST + "/");
  }
}

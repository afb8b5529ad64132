package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;

/**
 * One of the twelve ways through the intersection: from arrival zone {@code from}0, through {@code
 * from} and its successors.
 */
public record Route(Zone from, Turn turn) {

  /** All twelve. */
  public static List<Route> all() {
    List<Route> routes = new ArrayList<>();
    for (Zone from : Zone.values()) {
      for (Turn turn : Turn.values()) {
        routes.add(new Route(from, turn));
      }
    }
    return List.copyOf(routes);
  }

  /** The critical zones in the order in which they are crossed. */
  public List<Zone> zones() {
    List<Zone> zones = new ArrayList<>();
    Zone zone = from;
    for (int i = 0; i < turn.zones(); i++) {
      zones.add(zone);
      zone = zone.next();
    }
    return List.copyOf(zones);
  }

  public Zone lastZone() {
    return zones().get(turn.zones() - 1);
  }

  /** {@code A0}. */
  public String arrival() {
    return from + "0";
  }

  /** {@code D1}. */
  public String departure() {
    return lastZone() + "1";
  }

  /** The paper's notation: {@code A0 A C D D1}. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(arrival());
    for (Zone zone : zones()) {
      text.append(' ').append(zone);
    }
    return text.append(' ').append(departure()).toString();
  }
}

package org.starl.apps.intersection.logic;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.starl.geometry.ItemPosition;

/**
 * One car's trip: a station in each zone, in order, the last one in the departure zone; then the exit,
 * past it. Each station has its zone's name. A parked car's trip has no stations.
 *
 * @param label for people: {@code A0 A C D D1}
 * @param route if it is one of the twelve
 * @param approach the places of its arm to which it drives first, the arrival zone last; empty for a
 *     car that starts there
 */
public record Trip(
    String label,
    Optional<Route> route,
    List<ItemPosition> approach,
    List<ItemPosition> stations,
    ItemPosition exit) {

  public Trip {
    approach = List.copyOf(approach);
    stations = List.copyOf(stations);
  }

  /** The trip of a car that stays at {@code place} and takes no part. */
  public static Trip parked(ItemPosition place) {
    return new Trip("parked", Optional.empty(), List.of(), List.of(), place);
  }

  /** The zones to be held, in order: the stations' names. */
  public List<String> zones() {
    return stations.stream().map(ItemPosition::name).collect(Collectors.toList());
  }
}

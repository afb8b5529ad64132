package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.ItemPosition;

/**
 * What one car drives: a station in each zone, named as the zone, in order; the last one in the
 * departure zone; then the exit, past it. A trip without stations is that of a parked car.
 *
 * @param label for people: {@code A0 A C D D1}
 */
public record Trip(String label, List<ItemPosition> stations, ItemPosition exit) {

  public Trip {
    stations = List.copyOf(stations);
  }

  /** The trip of a car that stays at {@code place} and takes no part. */
  public static Trip parked(ItemPosition place) {
    return new Trip("parked", List.of(), place);
  }

  /** The zones to be held, in order: the stations' names. */
  public List<String> zones() {
    List<String> zones = new ArrayList<>();
    stations.forEach(station -> zones.add(station.name()));
    return zones;
  }
}

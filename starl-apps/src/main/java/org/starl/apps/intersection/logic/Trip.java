package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.ItemPosition;

/**
 * What one car drives: a station in each zone, named as the zone, in order; the last one in the
 * departure zone; then the exit, past it. A trip without stations is that of a parked car.
 *
 * @param label for people: {@code A0 A C D D1}
 * @param approach the places of its arm up which it comes, the arrival zone last; empty for a car
 *     that begins there
 */
public record Trip(
    String label, List<ItemPosition> approach, List<ItemPosition> stations, ItemPosition exit) {

  public Trip {
    approach = List.copyOf(approach);
    stations = List.copyOf(stations);
  }

  /** The trip of a car that begins in the arrival zone. */
  public Trip(String label, List<ItemPosition> stations, ItemPosition exit) {
    this(label, List.of(), stations, exit);
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

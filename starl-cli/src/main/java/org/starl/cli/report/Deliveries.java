package org.starl.cli.report;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.primitives.Phases;
import org.starl.primitives.monitor.PrimitivePhases;

/**
 * How often each type of message was delivered, by the phase of its primitive and the location of the
 * app on the receiving robot.
 */
final class Deliveries {

  /** The location of an app that has not traced one. */
  static final String NO_LOCATION = "-";

  /** The phase of a primitive that {@link PrimitivePhases} does not have. */
  static final String NO_PHASE = "-";

  private static final int MAX_NEVER = 8;

  /** By channel without instance, location, phase and type of message. */
  @JsonValue
  private final SortedMap<String, SortedMap<String, SortedMap<String, SortedMap<String, Long>>>>
      counts;

  @JsonCreator(mode = JsonCreator.Mode.DELEGATING)
  Deliveries(
      SortedMap<String, SortedMap<String, SortedMap<String, SortedMap<String, Long>>>> counts) {
    this.counts = counts;
  }

  /** Of no run. */
  Deliveries() {
    this(new TreeMap<>());
  }

  /** The counts by type; the caller may change them. */
  SortedMap<String, Long> in(String channel, String location, String phase) {
    return counts
        .computeIfAbsent(channel, any -> new TreeMap<>())
        .computeIfAbsent(location, any -> new TreeMap<>())
        .computeIfAbsent(phase, any -> new TreeMap<>());
  }

  /** Adds other runs. */
  void add(Deliveries other) {
    other.counts.forEach((channel, locations) ->
        locations.forEach((location, phases) ->
            phases.forEach((phase, types) -> {
              SortedMap<String, Long> sums = in(channel, location, phase);
              types.forEach((type, count) -> sums.merge(type, count, Long::sum));
            })));
  }

  /** Of all combinations that were reached. */
  List<String> names() {
    List<String> names = new ArrayList<>();
    counts.forEach((channel, locations) ->
        locations.forEach((location, phases) ->
            phases.forEach((phase, types) ->
                types
                    .keySet()
                    .forEach(
                        type -> names.add(String.join(" ", channel, location, phase, type))))));
    return names;
  }

  /** A line for each channel with a delivery. */
  List<String> lines() {
    return tables().stream().map(Table::line).toList();
  }

  /** The table of each channel with a delivery, ordered by their names. */
  List<Table> tables() {
    return counts.entrySet().stream()
        .map(entry -> table(entry.getKey(), entry.getValue()))
        .toList();
  }

  private static Table table(
      String channel, SortedMap<String, SortedMap<String, SortedMap<String, Long>>> locations) {
    Set<String> types = new LinkedHashSet<>();
    Set<String> phases = new LinkedHashSet<>();
    for (Phases known : PrimitivePhases.ALL) {
      Class<?> messages = known.channels().get(channel);
      if (messages != null) {
        phases.addAll(known.names());
        for (Class<?> type : messages.getPermittedSubclasses()) {
          types.add(type.getSimpleName());
        }
      }
    }
    for (SortedMap<String, SortedMap<String, Long>> ofPhases : locations.values()) {
      phases.addAll(ofPhases.keySet());
      ofPhases.values().forEach(ofTypes -> types.addAll(ofTypes.keySet()));
    }
    List<Place> places = new ArrayList<>();
    for (String phase : phases) {
      locations.forEach((location, ofPhases) -> {
        SortedMap<String, Long> ofTypes = ofPhases.get(phase);
        if (ofTypes != null) {
          places.add(new Place(phase, location, ofTypes));
        }
      });
    }
    return new Table(channel, List.copyOf(types), List.copyOf(phases), places);
  }

  /** A phase and a location in which a message of the channel was delivered, with the counts. */
  record Place(String phase, String location, SortedMap<String, Long> types) {

    long count(String type) {
      return types.getOrDefault(type, 0L);
    }
  }

  /**
   * The combinations of one channel.
   *
   * @param types those that the protocol declares, and any others that were delivered
   * @param phases likewise
   */
  record Table(String channel, List<String> types, List<String> phases, List<Place> places) {

    /** Whether the app traces its location. */
    boolean hasLocations() {
      return places.stream().anyMatch(place -> !place.location.equals(NO_LOCATION));
    }

    /** The places of one phase; none if no message was delivered in it. */
    List<Place> places(String phase) {
      return places.stream().filter(place -> place.phase.equals(phase)).toList();
    }

    /** {@code deliveries of mutex: 33 of 77 combinations of type, phase and location; never: Fence}. */
    String line() {
      List<String> never = never();
      String shown = String.join(", ", never.subList(0, Math.min(MAX_NEVER, never.size())));
      int more = never.size() - MAX_NEVER;
      long reached = places.stream().mapToLong(place -> place.types.size()).sum();
      long empty = phases.stream().filter(phase -> places(phase).isEmpty()).count();
      return "deliveries of %s: %d of %d combinations of type%s%s%s"
          .formatted(
              channel,
              reached,
              types.size() * (places.size() + empty),
              hasLocations() ? ", phase and location" : " and phase",
              never.isEmpty() ? "" : "; never: " + shown,
              more > 0 ? " and " + more + " more" : "");
    }

    /**
     * What was never reached, the widest first: {@code all in OUT} for a phase without a delivery,
     * {@code Fence} for a type in no phase, {@code Ok in IDLE} for one at no location of a phase, and
     * {@code Ok in IDLE at DONE}.
     */
    List<String> never() {
      List<String> never = new ArrayList<>();
      List<String> ofPhases = new ArrayList<>();
      List<String> ofPlaces = new ArrayList<>();
      phases.stream().filter(at -> places(at).isEmpty()).forEach(at -> never.add("all in " + at));
      for (String type : types) {
        if (places.stream().allMatch(place -> place.count(type) == 0)) {
          never.add(type);
          continue;
        }
        for (String phase : phases) {
          List<Place> missing =
              places(phase).stream().filter(place -> place.count(type) == 0).toList();
          String name = type + " in " + phase;
          if (missing.size() < places(phase).size()) {
            missing.forEach(place -> ofPlaces.add(name + " at " + place.location));
          } else if (!missing.isEmpty()) {
            ofPhases.add(name);
          }
        }
      }
      never.addAll(ofPhases);
      never.addAll(ofPlaces);
      return never;
    }
  }
}

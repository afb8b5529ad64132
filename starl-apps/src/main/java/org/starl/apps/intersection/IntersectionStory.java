package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/** Reports when each car came, registered, waited and crossed. */
final class IntersectionStory implements Story {

  private static final double NS_PER_S = 1e9;

  // Each car's trips in order; a car that is put on the floor again starts another trip.
  private final SortedMap<RobotId, List<Crossed>> cars = new TreeMap<>();

  /** One trip. Times in ns; negative for what has not happened. */
  private static final class Crossed {
    private String trip = "?";
    private List<String> rest = List.of();
    private long crashedNs = -1;
    private long cameNs = -1;
    private long askedNs = -1;
    private long grantedNs = -1;
    private long leftNs = -1;
    private long doneNs = -1;
    private int stops;
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof TraceEvent.Fault fault && !fault.name().equals(TraceEvent.Fault.CRASH)) {
      return; // may be about no car
    }
    Crossed car = latest(event.robot());
    CrossingTrace.trip(event).ifPresent(trip -> car.trip = trip.label());
    CrossingTrace.myseq(event).ifPresent(myseq -> car.rest = myseq);
    CrossingTrace.location(event).ifPresent(location -> located(car, location, event.timeNs()));
    if (CrossingTrace.isStopped(event)) {
      car.stops++;
    }
    switch (event) {
      case TraceEvent.Joined joined -> came(joined.robot(), joined.timeNs());
      case TraceEvent.Left left -> car.leftNs = left.timeNs();
      case TraceEvent.Fault crash -> car.crashedNs = crash.timeNs();
      default -> {
        // Not part of the story.
      }
    }
  }

  private void came(RobotId robot, long timeNs) {
    Crossed last = latest(robot);
    if (last.cameNs < 0) {
      last.cameNs = timeNs;
      return;
    }
    Crossed again = new Crossed();
    again.trip = last.trip;
    again.cameNs = timeNs;
    trips(robot).add(again);
  }

  private static void located(Crossed car, Location location, long timeNs) {
    if (location == Location.MUTEX_WAIT && car.askedNs < 0) {
      car.askedNs = timeNs;
    } else if (location == Location.MOVE_WAIT) {
      car.grantedNs = timeNs;
    } else if (location == Location.DONE) {
      car.doneNs = timeNs;
    }
  }

  private Crossed latest(RobotId robot) {
    List<Crossed> trips = trips(robot);
    return trips.get(trips.size() - 1);
  }

  private List<Crossed> trips(RobotId robot) {
    return cars.computeIfAbsent(robot, id -> new ArrayList<>(List.of(new Crossed())));
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    cars.forEach((robot, trips) -> trips.forEach(trip -> lines.add(line(robot, trip))));
    return lines;
  }

  private static String line(RobotId robot, Crossed car) {
    String name = robot + " (" + car.trip + ")";
    if (car.cameNs < 0) {
      return name + " never came onto the floor";
    }
    List<String> parts = new ArrayList<>(List.of(name + " came at " + seconds(car.cameNs)));
    if (car.askedNs >= 0) {
      parts.add("was registered at " + seconds(car.askedNs));
    }
    if (car.grantedNs >= 0) {
      parts.add("waited " + seconds(car.grantedNs - car.askedNs));
    } else if (car.askedNs >= 0 && car.crashedNs < 0) {
      parts.add("still waits for " + car.rest);
    }
    if (car.stops > 0) {
      parts.add("was stopped " + (car.stops == 1 ? "once" : car.stops + " times"));
    }
    if (car.leftNs >= 0) {
      parts.add("left the floor at " + seconds(car.leftNs));
    }
    if (car.doneNs > 0) {
      parts.add("was unregistered at " + seconds(car.doneNs));
    }
    if (car.crashedNs >= 0) {
      boolean wasInside = car.grantedNs >= 0 && car.leftNs < 0;
      String rest = wasInside ? " with " + car.rest + " ahead" : "";
      parts.add("crashed at " + seconds(car.crashedNs) + rest);
    }
    return String.join(", ", parts);
  }

  @Override
  public Measures measures() {
    List<Crossed> trips = cars.values().stream().flatMap(List::stream).toList();
    List<Long> waitsNs =
        trips.stream().filter(t -> t.grantedNs >= 0).map(t -> t.grantedNs - t.askedNs).toList();
    return new Measures(cars.size(), leftNs().size(), waitsNs);
  }

  private List<Long> leftNs() {
    return cars.values().stream()
        .flatMap(List::stream)
        .filter(trip -> trip.leftNs >= 0)
        .map(trip -> trip.leftNs)
        .toList();
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.howLong("wait from registration to the grant of all zones", measures().waitsNs()),
        Sample.when("crossings", leftNs()));
  }

  static String seconds(long ns) {
    return String.format(Locale.ROOT, "%.1f s", ns / NS_PER_S);
  }
}

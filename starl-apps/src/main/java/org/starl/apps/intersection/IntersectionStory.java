package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.ToLongFunction;
import java.util.stream.Stream;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/** Reports when each car came, registered, waited and crossed. */
final class IntersectionStory implements Story {

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
    if (event instanceof Fault fault && !fault.name().equals(Fault.CRASH)) {
      return; // may be about no car
    }
    List<Crossed> trips =
        cars.computeIfAbsent(event.robot(), id -> new ArrayList<>(List.of(new Crossed())));
    Crossed car = trips.get(trips.size() - 1);
    switch (event) {
      case Action action -> CrossingFact.trip(action).ifPresent(trip -> car.trip = trip.label());
      case Variable variable -> changed(car, variable);
      case Joined joined when car.cameNs < 0 -> car.cameNs = joined.timeNs();
      case Joined joined -> {
        Crossed again = new Crossed();
        again.trip = car.trip;
        again.cameNs = joined.timeNs();
        trips.add(again);
      }
      case Left left -> car.leftNs = left.timeNs();
      case Fault crash -> car.crashedNs = crash.timeNs();
      default -> {
        // Not part of the story.
      }
    }
  }

  private static void changed(Crossed car, Variable variable) {
    CrossingFact.myseq(variable).ifPresent(myseq -> car.rest = myseq);
    CrossingFact.location(variable)
        .ifPresent(location -> located(car, location, variable.timeNs()));
    if (CrossingFact.isStopped(variable)) {
      car.stops++;
    }
  }

  private static void located(Crossed car, Location location, long timeNs) {
    if (location == Location.MUTEX_WAIT && car.askedNs < 0) {
      car.askedNs = timeNs;
    } else if (location == Location.MOVE_WAIT) {
      car.askedNs = car.askedNs < 0 ? timeNs : car.askedNs; // granted within a period
      car.grantedNs = timeNs;
    } else if (location == Location.DONE) {
      car.doneNs = timeNs;
    }
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
    StringBuilder line = new StringBuilder(name + " came at " + Time.text(car.cameNs, 1));
    if (car.askedNs >= 0) {
      line.append(", was registered at ").append(Time.text(car.askedNs, 1));
    }
    if (car.grantedNs >= 0) {
      line.append(", waited ").append(Time.text(car.grantedNs - car.askedNs, 1));
    } else if (car.askedNs >= 0 && car.crashedNs < 0) {
      line.append(", still waits for ").append(car.rest);
    }
    if (car.stops > 0) {
      line.append(", was stopped ").append(times(car.stops));
    }
    if (car.leftNs >= 0) {
      line.append(", left the floor at ").append(Time.text(car.leftNs, 1));
    }
    if (car.doneNs > 0) {
      line.append(", was unregistered at ").append(Time.text(car.doneNs, 1));
    }
    if (car.crashedNs >= 0) {
      line.append(", crashed at ").append(Time.text(car.crashedNs, 1));
      line.append(car.grantedNs >= 0 && car.leftNs < 0 ? " with " + car.rest + " ahead" : "");
    }
    return line.toString();
  }

  /** {@code once}, {@code 3 times}. */
  static String times(int count) {
    return count == 1 ? "once" : count + " times";
  }

  @Override
  public Measures measures() {
    return new Measures(cars.size(), leftNs().size(), waitsNs());
  }

  @Override
  public List<Sample> samples() {
    return List.of(
        Sample.howLong("wait from registration to the grant of all zones", waitsNs()),
        Sample.when("crossings", leftNs()));
  }

  private List<Long> waitsNs() {
    return trips(trip -> trip.grantedNs).map(trip -> trip.grantedNs - trip.askedNs).toList();
  }

  private List<Long> leftNs() {
    return trips(trip -> trip.leftNs).map(trip -> trip.leftNs).toList();
  }

  /** The trips for which {@code timeNs} has come. */
  private Stream<Crossed> trips(ToLongFunction<Crossed> timeNs) {
    return cars.values().stream()
        .flatMap(List::stream)
        .filter(trip -> timeNs.applyAsLong(trip) >= 0);
  }
}

package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexEvent;
import org.starl.primitives.mutex.MutexTrace;
import org.starl.trace.TraceEvent;

/**
 * Who holds and who requests which zones and places, as the mutexes' trace tells it: crit_set and
 * req_set. Of robots that have left the floor and hold nothing, nothing is kept.
 */
public final class HeldZones {

  private static final SortedSet<String> NONE = Collections.emptySortedSet();

  private final String onlySource;
  private final Map<RobotId, Car> cars = new TreeMap<>();

  private record Hold(ProcessId who, SortedSet<String> sections) {}

  /** What one car holds, requests and was refused, by mutex. */
  private static final class Car {
    private final Map<String, Hold> held = new TreeMap<>();
    private final Map<String, SortedSet<String>> requested = new TreeMap<>();
    private final Set<String> refused = new TreeSet<>();

    Car copy() {
      Car copy = new Car();
      copy.held.putAll(held);
      copy.requested.putAll(requested);
      copy.refused.addAll(refused);
      return copy;
    }
  }

  /** Of all mutexes. */
  public HeldZones() {
    onlySource = "";
  }

  /** Of the mutex {@code xid} alone. */
  public HeldZones(String xid) {
    onlySource = MutexTrace.source(xid);
  }

  private HeldZones(HeldZones other) {
    onlySource = other.onlySource;
    other.cars.forEach((robot, car) -> cars.put(robot, car.copy()));
  }

  /** The same at this moment, from now on apart. */
  public HeldZones copy() {
    return new HeldZones(this);
  }

  /** Sees the next event. */
  public void observe(TraceEvent event) {
    if (event instanceof TraceEvent.Action action
        && (onlySource.isEmpty() || action.source().equals(onlySource))) {
      MutexTrace.read(event).ifPresent(e -> observe(action.source(), e));
    } else if (event instanceof TraceEvent.Left left && held(left.robot()).isEmpty()) {
      cars.remove(left.robot());
    }
  }

  private void observe(String mutex, MutexEvent event) {
    switch (event) {
      case MutexEvent.DoMutex request -> {
        Car car = car(request);
        car.requested.put(mutex, request.want());
        car.refused.remove(mutex);
      }
      case MutexEvent.OdMutex grant -> {
        Car car = car(grant);
        car.requested.remove(mutex);
        car.held.put(mutex, new Hold(grant.who(), grant.held()));
      }
      case MutexEvent.Release release -> holds(car(release), mutex, release.who(), release.left());
      case MutexEvent.Withdraw withdrawal -> {
        Car car = car(withdrawal);
        car.requested.remove(mutex);
        car.refused.add(mutex);
      }
      case MutexEvent.Grant consent -> {
        // Consent of one peer gives nothing yet.
      }
      case MutexEvent.Known known -> {
        // Nor does knowing whom to ask.
      }
      case MutexEvent.Learned view -> {
        // Nor does who takes part.
      }
      case MutexEvent.Fence vow -> {
        // A vow takes nothing from whom it is about.
      }
      case MutexEvent.StandsIn word -> startedAnew(car(word), mutex, word);
    }
  }

  /** What an earlier start of the car's program held, was its own; of that, the body is in these. */
  private static void startedAnew(Car car, String mutex, MutexEvent.StandsIn word) {
    Hold hold = car.held.get(mutex);
    if (hold != null && bootOf(hold.who()) < bootOf(word.who())) {
      TreeSet<String> left = new TreeSet<>(hold.sections());
      left.retainAll(word.sections());
      holds(car, mutex, hold.who(), left);
      car.requested.remove(mutex);
    }
  }

  private static long bootOf(ProcessId id) {
    return id.inc() >>> Integer.SIZE;
  }

  private Car car(MutexEvent event) {
    return cars.computeIfAbsent(event.who().robot(), robot -> new Car());
  }

  private static void holds(Car car, String mutex, ProcessId who, SortedSet<String> left) {
    if (left.isEmpty()) {
      car.held.remove(mutex);
    } else {
      car.held.put(mutex, new Hold(who, left));
    }
  }

  /** crit_set: what {@code robot} has access to. */
  public SortedSet<String> held(RobotId robot) {
    Car car = cars.get(robot);
    if (car == null || car.held.isEmpty()) {
      return NONE;
    }
    TreeSet<String> all = new TreeSet<>();
    car.held.values().forEach(hold -> all.addAll(hold.sections()));
    return all;
  }

  /** Whether {@code robot} has access to {@code zone}. */
  boolean holds(RobotId robot, String zone) {
    Car car = cars.get(robot);
    if (car != null) {
      for (Hold hold : car.held.values()) {
        if (hold.sections().contains(zone)) {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether a latest request of {@code robot} ended without access. */
  boolean isRefused(RobotId robot) {
    Car car = cars.get(robot);
    return car != null && !car.refused.isEmpty();
  }

  /** Everybody who may hold something, in order. */
  Set<RobotId> holders() {
    return cars.keySet();
  }

  /** req_set: what {@code robot} waits for. */
  SortedSet<String> requested(RobotId robot) {
    Car car = cars.get(robot);
    if (car == null || car.requested.isEmpty()) {
      return NONE;
    }
    TreeSet<String> all = new TreeSet<>();
    car.requested.values().forEach(all::addAll);
    return all;
  }

  /** Reads a variable whose value is a list: {@code [A, C, D1]}. */
  static List<String> list(String value) {
    List<String> names = new ArrayList<>();
    for (String name : value.substring(1, value.length() - 1).split(", ", -1)) {
      if (!name.isEmpty()) {
        names.add(name);
      }
    }
    return names;
  }
}

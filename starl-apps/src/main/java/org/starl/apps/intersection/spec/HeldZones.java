package org.starl.apps.intersection.spec;

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
 * The zones and places that each robot holds (crit_set) and requests (req_set), read from the mutexes'
 * events in a trace. Forgets robots that have left the floor and hold nothing.
 */
public final class HeldZones {

  private final String onlySource;
  private final Map<RobotId, Car> cars = new TreeMap<>();

  private record Hold(ProcessId who, SortedSet<String> sections) {}

  /** What one car holds, requests and was refused, by mutex. */
  private record Car(
      Map<String, Hold> held, Map<String, SortedSet<String>> requested, Set<String> refused) {
    Car() {
      this(new TreeMap<>(), new TreeMap<>(), new TreeSet<>());
    }

    Car copy() {
      return new Car(new TreeMap<>(held), new TreeMap<>(requested), new TreeSet<>(refused));
    }

    void holds(String mutex, ProcessId who, SortedSet<String> left) {
      if (left.isEmpty()) {
        held.remove(mutex);
      } else {
        held.put(mutex, new Hold(who, left));
      }
    }
  }

  /** Of all mutexes. */
  public HeldZones() {
    onlySource = "";
  }

  /** Of the mutex {@code xid} only. */
  public HeldZones(String xid) {
    onlySource = MutexTrace.source(xid);
  }

  private HeldZones(HeldZones other) {
    onlySource = other.onlySource;
    other.cars.forEach((robot, car) -> cars.put(robot, car.copy()));
  }

  /** An independent copy of the present state. */
  public HeldZones copy() {
    return new HeldZones(this);
  }

  /** Takes the next event of the trace. */
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
      case MutexEvent.Release release -> car(release).holds(mutex, release.who(), release.left());
      case MutexEvent.Withdraw withdrawal -> {
        Car car = car(withdrawal);
        car.requested.remove(mutex);
        car.refused.add(mutex);
      }
      case MutexEvent.StandsIn word -> restarted(car(word), mutex, word);
      default -> {
        // Changes neither a request nor what is held.
      }
    }
  }

  private Car car(MutexEvent event) {
    return cars.computeIfAbsent(event.who().robot(), robot -> new Car());
  }

  /** Of what an earlier process of the robot held, the robot keeps only the sections it is in. */
  private static void restarted(Car car, String mutex, MutexEvent.StandsIn word) {
    Hold hold = car.held.get(mutex);
    if (hold != null && boot(hold.who()) < boot(word.who())) {
      TreeSet<String> left = new TreeSet<>(hold.sections());
      left.retainAll(word.sections());
      car.holds(mutex, hold.who(), left);
      car.requested.remove(mutex);
    }
  }

  private static long boot(ProcessId id) {
    return id.inc() >>> Integer.SIZE;
  }

  /** The crit_set of {@code robot}: the sections that it has access to. */
  public SortedSet<String> held(RobotId robot) {
    TreeSet<String> all = new TreeSet<>();
    if (cars.containsKey(robot)) {
      cars.get(robot).held.values().forEach(hold -> all.addAll(hold.sections()));
    }
    return all;
  }

  /** Whether {@code robot} has access to {@code zone}. */
  boolean holds(RobotId robot, String zone) {
    Car car = cars.get(robot);
    return car != null
        && car.held.values().stream().anyMatch(hold -> hold.sections().contains(zone));
  }

  /** Whether a latest request of {@code robot} ended without access. */
  boolean isRefused(RobotId robot) {
    return cars.containsKey(robot) && !cars.get(robot).refused.isEmpty();
  }

  /** All robots that may hold something, in order. */
  Set<RobotId> holders() {
    return cars.keySet();
  }

  /** The req_set of {@code robot}: the sections that it waits for. */
  SortedSet<String> requested(RobotId robot) {
    TreeSet<String> all = new TreeSet<>();
    if (cars.containsKey(robot)) {
      cars.get(robot).requested.values().forEach(all::addAll);
    }
    return all;
  }
}

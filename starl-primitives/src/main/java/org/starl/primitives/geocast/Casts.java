package org.starl.primitives.geocast;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.Monitor.Report;
import org.starl.spec.automaton.Fun;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;

/**
 * Follows the true bodies of a run through the areas of its geocasts during their intervals.
 * Decides for {@link GeocastSpec} and {@link GeocastConformance} which robots have been in an area.
 */
final class Casts {

  /** Receives the effects of the next event on bodies and intervals, before the event is used. */
  interface Listener {

    /** The body of {@code robot} is found in the area for the first time, at {@code event}. */
    default void entered(CastRecord cast, RobotId robot, TraceEvent event, Report report) {}

    /** The interval is over; all bodies were followed to its end, and the record is removed. */
    void over(CastRecord cast, Report report);
  }

  private record Key(Instance source, GeocastId id) {}

  private final double deepMm;
  private final Listener listener;
  private final RobotNumbers numbers = new RobotNumbers();
  private final Bodies bodies = new Bodies();
  private final Map<RobotId, Double> speeds = new TreeMap<>();

  /** The robots that take part in each instance. */
  private final Map<Instance, Fun<RobotId, Boolean>> members = new TreeMap<>();

  /** The robots whose bodies are on the floor. */
  private Fun<RobotId, Boolean> onFloor = Fun.always(false);

  /** Geocasts whose interval is not over, by source and id, in the order of their starts. */
  private final Map<Key, CastRecord> active = new LinkedHashMap<>();

  /** Those whose area has a border. */
  private final Set<CastRecord> bordered = new LinkedHashSet<>();

  private long firstDeadlineNs = Long.MAX_VALUE;

  /**
   * @param deepMm the least distance from the border of a robot deep inside
   */
  Casts(double deepMm, Listener listener) {
    this.deepMm = deepMm;
    this.listener = listener;
  }

  /** The geocast of an instance; null if its interval is over, or has not begun. */
  @Nullable CastRecord of(Instance source, GeocastId id) {
    return active.get(new Key(source, id));
  }

  /** How deep in the area the body is now; minus infinity off the floor. */
  double depthMm(CastRecord cast, RobotId robot, long nowNs) {
    return bodies.isOnFloor(robot)
        ? cast.area.depthMm(bodies.poseAt(robot, nowNs).at())
        : Double.NEGATIVE_INFINITY;
  }

  /** Processes the next event. */
  void observe(TraceEvent event, Report report) {
    forgetFinished(event.timeNs(), report);
    switch (event) {
      case Action action -> acted(action, report);
      case Moved moved -> {
        followAll(moved, report);
        speeds.put(moved.robot(), Math.abs(moved.linearMmPerS()));
        bodies.observe(moved);
      }
      case Joined joined -> {
        speeds.remove(joined.robot());
        bodies.observe(joined);
        onFloor = onFloor.with(joined.robot(), true);
        active.values().forEach(cast -> cast.bodies.watch(joined.robot(), joined.timeNs()));
      }
      case Left left -> {
        followAll(left, report);
        active.values().forEach(cast -> cast.bodies.left(left.robot()));
        onFloor = onFloor.with(left.robot(), false);
        bodies.observe(left);
      }
      default -> {}
    }
  }

  /** Ends the intervals that are over at the end of the run. */
  void finish(long endNs, Report report) {
    forgetFinished(endNs + 1, report);
  }

  private void acted(Action action, Report report) {
    switch (action.fact()) {
      case GeocastFact.Opened f -> opened(action);
      case GeocastFact.do_geocast f -> started(action, f.m(), f.area(), f.bound(), report);
      case GeocastFact.BCast f -> started(action, f.m(), f.area(), f.bound(), report);
      case GeocastFact.deliver f -> {
        CastRecord cast = of(action.source(), f.m());
        if (cast != null) {
          follow(cast, action.robot(), action, report);
        }
      }
      default -> {}
    }
  }

  /** A robot that opens an instance again has restarted, and has forgotten its deliveries. */
  private void opened(Action action) {
    Fun<RobotId, Boolean> known = membersOf(action.source());
    if (!known.at(action.robot())) {
      members.put(action.source(), known.with(action.robot(), true));
      return;
    }
    for (CastRecord cast : active.values()) {
      if (cast.source.equals(action.source())) {
        cast.restarted(action.robot());
      }
    }
  }

  private void started(Action action, GeocastId id, Region area, long dNs, Report report) {
    long startNs = action.timeNs();
    long deadlineNs = startNs + dNs;
    boolean isEverywhere = area instanceof Everywhere;
    CastRecord cast =
        new CastRecord(
            action.source(),
            action.robot(),
            id,
            area,
            startNs,
            deadlineNs,
            numbers,
            membersOf(action.source()),
            isEverywhere
                ? new Whereabouts.OnFloor(onFloor, startNs)
                : new Whereabouts.InArea(area, deepMm, startNs));
    if (!isEverywhere) {
      for (RobotId robot : bodies.robots()) {
        cast.bodies.watch(robot, startNs);
        follow(cast, robot, action, report);
      }
      bordered.add(cast);
    }
    CastRecord before = active.put(new Key(cast.source, cast.id), cast);
    if (before != null) {
      bordered.remove(before);
    }
    firstDeadlineNs = Math.min(firstDeadlineNs, deadlineNs);
  }

  private void followAll(TraceEvent event, Report report) {
    for (CastRecord cast : bordered) {
      follow(cast, event.robot(), event, report);
    }
  }

  private void follow(CastRecord cast, RobotId robot, TraceEvent event, Report report) {
    if (entersUntil(event.timeNs(), cast, robot)) {
      listener.entered(cast, robot, event, report);
    }
  }

  private boolean entersUntil(long toNs, CastRecord cast, RobotId robot) {
    return bodies.isOnFloor(robot)
        && cast.bodies.follow(robot, bodies, speeds.getOrDefault(robot, 0.0), toNs);
  }

  private void forgetFinished(long nowNs, Report report) {
    if (nowNs <= firstDeadlineNs) {
      return;
    }
    firstDeadlineNs = Long.MAX_VALUE;
    Iterator<CastRecord> oldestFirst = active.values().iterator();
    while (oldestFirst.hasNext()) {
      CastRecord cast = oldestFirst.next();
      if (nowNs > cast.deadlineNs) {
        if (bordered.remove(cast)) {
          bodies.robots().forEach(robot -> entersUntil(cast.deadlineNs, cast, robot));
        }
        listener.over(cast, report);
        oldestFirst.remove();
      } else {
        firstDeadlineNs = Math.min(firstDeadlineNs, cast.deadlineNs);
      }
    }
  }

  private Fun<RobotId, Boolean> membersOf(Instance source) {
    return members.getOrDefault(source, Fun.always(false));
  }
}

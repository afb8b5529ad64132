package org.starl.primitives.geocast;

import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.RegionText;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
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

    /** The body of {@code robot} is found in the area for the first time. */
    default void entered(CastRecord cast, RobotId robot) {}

    /** The interval is over; all bodies were followed to its end, and the record is removed. */
    void over(CastRecord cast);
  }

  private final double deepMm;
  private final Bodies bodies = new Bodies();
  private final Map<RobotId, Double> speeds = new TreeMap<>();

  /** The robots that take part in each instance. */
  private final Map<String, TreeSet<RobotId>> members = new TreeMap<>();

  /** Geocasts whose interval is not over, by source and id, in the order of their starts. */
  private final Map<String, CastRecord> active = new LinkedHashMap<>();

  private long firstDeadlineNs = Long.MAX_VALUE;

  /**
   * @param deepMm the least distance from the border of a robot deep inside
   */
  Casts(double deepMm) {
    this.deepMm = deepMm;
  }

  /** The geocasts whose interval is not over, in the order of their starts. */
  Collection<CastRecord> active() {
    return Collections.unmodifiableCollection(active.values());
  }

  /** The geocast of an action; null if its interval is over, or has not begun. */
  @Nullable CastRecord of(Action action) {
    return action.args().isEmpty() ? null : of(action.source(), action.args().get(0));
  }

  /** The geocast of an instance; null if its interval is over, or has not begun. */
  @Nullable CastRecord of(String source, String id) {
    return active.get(source + " " + id);
  }

  /** Processes the next event. */
  void observe(TraceEvent event, Listener listener) {
    forgetFinished(event.timeNs(), listener);
    switch (event) {
      case Action action when GeocastTrace.isGeocast(action.source()) -> acted(action, listener);
      case Moved moved -> {
        followAll(moved.robot(), moved.timeNs(), listener);
        speeds.put(moved.robot(), Math.abs(moved.linearMmPerS()));
        bodies.observe(moved);
      }
      case Joined joined -> {
        speeds.remove(joined.robot());
        bodies.observe(joined);
        active.values().forEach(cast -> cast.watch(joined.robot(), deepMm, joined.timeNs()));
      }
      case Left left -> {
        followAll(left.robot(), left.timeNs(), listener);
        active.values().forEach(cast -> cast.left(left.robot()));
        bodies.observe(left);
      }
      default -> {}
    }
  }

  /** Ends the intervals that are over at the end of the run. */
  void finish(long endNs, Listener listener) {
    forgetFinished(endNs + 1, listener);
  }

  private void acted(Action action, Listener listener) {
    switch (action.name()) {
      case GeocastTrace.OPEN -> opened(action);
      case GeocastTrace.DO_GEOCAST, GeocastTrace.B_CAST -> started(action, listener);
      case GeocastTrace.DELIVER -> {
        CastRecord cast = of(action);
        if (cast != null) {
          follow(cast, action.robot(), action.timeNs(), listener);
        }
      }
      default -> {}
    }
  }

  /** A robot that opens an instance again has restarted, and has forgotten its deliveries. */
  private void opened(Action action) {
    if (!membersOf(action.source()).add(action.robot())) {
      for (CastRecord cast : active.values()) {
        if (cast.source.equals(action.source())) {
          cast.restarted(action.robot());
        }
      }
    }
  }

  private void started(Action action, Listener listener) {
    long startNs = action.timeNs();
    long deadlineNs = startNs + Long.parseLong(action.args().get(2));
    CastRecord cast =
        new CastRecord(
            action.source(),
            action.robot(),
            action.args().get(0),
            RegionText.parse(action.args().get(1)),
            startNs,
            deadlineNs);
    cast.owed.addAll(membersOf(action.source()));
    cast.owed.remove(action.robot());
    for (RobotId robot : bodies.robots()) {
      cast.watch(robot, deepMm, startNs);
      follow(cast, robot, startNs, listener);
    }
    active.put(key(action), cast);
    firstDeadlineNs = Math.min(firstDeadlineNs, deadlineNs);
  }

  private void followAll(RobotId robot, long nowNs, Listener listener) {
    for (CastRecord cast : active.values()) {
      follow(cast, robot, nowNs, listener);
    }
  }

  private void follow(CastRecord cast, RobotId robot, long nowNs, Listener listener) {
    if (cast.follow(robot, bodies, speeds, nowNs)) {
      listener.entered(cast, robot);
    }
  }

  private void forgetFinished(long nowNs, Listener listener) {
    if (nowNs <= firstDeadlineNs) {
      return;
    }
    firstDeadlineNs = Long.MAX_VALUE;
    Iterator<CastRecord> oldestFirst = active.values().iterator();
    while (oldestFirst.hasNext()) {
      CastRecord cast = oldestFirst.next();
      if (nowNs > cast.deadlineNs) {
        bodies.robots().forEach(robot -> follow(cast, robot, nowNs, listener));
        listener.over(cast);
        oldestFirst.remove();
      } else {
        firstDeadlineNs = Math.min(firstDeadlineNs, cast.deadlineNs);
      }
    }
  }

  private TreeSet<RobotId> membersOf(String source) {
    return members.computeIfAbsent(source, name -> new TreeSet<>());
  }

  private static String key(Action action) {
    return action.source() + " " + action.args().get(0);
  }
}

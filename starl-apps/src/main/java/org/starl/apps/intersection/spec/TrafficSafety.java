package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.HeldSections;
import org.starl.primitives.mutex.MutexFact;
import org.starl.spec.Bodies;
import org.starl.spec.LemmaMonitor;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;

/**
 * {@code traffic_safety} (paper, section 3): no two cars occupy the same zone at the same time, nor the
 * same place of an arm. A car occupies a zone while any part of its true body is inside, whatever the
 * car believes.
 *
 * <p>Also {@code occupied_is_held}: a car that occupies a zone holds it. This is why {@code
 * traffic_safety} follows from {@code Inv_mux_safety}. It reports a zone that is released too early
 * even if no other car enters it.
 *
 * <p>Also {@code Inv_mux_safety} (paper, Figure 6): the crit_sets of any two cars are disjoint. The
 * mutex's {@code Exclusive} says the same of processes; this says it of cars, over all their processes.
 *
 * <p>Bodies are checked every 10 ms of movement: at 250 mm/s a body may be 2.5 mm inside a zone before
 * it is seen.
 */
final class TrafficSafety extends LemmaMonitor {

  private static final String SAFETY = "intersection.traffic_safety";
  private static final String HELD = "intersection.occupied_is_held";
  private static final String MUX = "intersection.Inv_mux_safety";

  /** The lemmas that need each car on its way. */
  static final List<String> OF_BODIES = List.of(SAFETY, HELD);

  private static final long STEP_NS = 10 * Time.NS_PER_MS;

  /** More than the rounding of poses. */
  private static final double ROUNDING_MM = 0.001;

  private final List<Zone> zones = new ArrayList<>();
  private final Bodies bodies = new Bodies();
  private final SortedMap<RobotId, Clearance> clearances = new TreeMap<>();
  private final HeldSections held = new HeldSections();
  private final SortedSet<String> reported = new TreeSet<>();
  private long checkedNs;

  // Whether a robot holds other zones than at the last check, or a body has come or gone.
  private boolean hasChanged;

  // No clearance is used up before this.
  private long sufficientUntilNs;

  // Occupants are few: a list costs less than a sorted set.
  private record Zone(String name, Region region, List<RobotId> occupants) {}

  /**
   * How far a body may move before it enters or leaves a zone. Almost all checks of a body end here,
   * without its pose.
   */
  private static final class Clearance {
    private Point from;
    private double wayMm;
    private double leftMm;
    private long sinceNs;
    private double mmPerNs;

    Clearance(Point from) {
      this.from = from;
    }

    /** The body is {@code wayMm} from the edge of the nearest zone. */
    void measured(Point at, double wayMm, long timeNs) {
      from = at;
      this.wayMm = wayMm;
      leftMm = wayMm;
      sinceNs = timeNs;
    }

    void moves(Moved moved) {
      leftMm = wayMm - from.distanceMm(moved.pose().at());
      sinceNs = moved.timeNs();
      mmPerNs = Math.abs(moved.linearMmPerS()) / Time.NS_PER_S;
    }

    boolean isUsedUp(long timeNs) {
      return leftMm - mmPerNs * (timeNs - sinceNs) < ROUNDING_MM;
    }

    /** Not after the time from which it is used up. */
    long sufficesUntilNs() {
      double restNs = (leftMm - ROUNDING_MM) / mmPerNs - STEP_NS;
      return restNs > 0 ? sinceNs + (long) Math.min(restNs, 1e18) : sinceNs;
    }
  }

  TrafficSafety(SortedMap<String, ? extends Region> zones) {
    lemma(SAFETY, "No two cars are in one zone at the same time, with any part of their bodies.");
    lemma(HELD, "A car that is in a zone, with any part of its body, holds that zone.");
    lemma(MUX, "No two cars hold the same zone.");
    zones.forEach((name, region) -> this.zones.add(new Zone(name, region, new ArrayList<>())));
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    checkUntil(event.timeNs(), report);
    bodies.observe(event);
    switch (event) {
      case Moved moved -> {
        Clearance clearance = clearances.get(moved.robot());
        if (clearance != null) {
          clearance.moves(moved);
          sufficientUntilNs = Math.min(sufficientUntilNs, clearance.sufficesUntilNs());
        }
      }
      case Joined joined -> {
        clearances.put(joined.robot(), new Clearance(joined.pose().at()));
        hasChanged = true;
      }
      case Left left -> {
        clearances.remove(left.robot());
        hasChanged = true;
      }
      case Action action when action.fact() instanceof MutexFact -> accessed(action, report);
      default -> {
        // Neither the bodies nor the zones that a robot holds.
      }
    }
  }

  private void accessed(Action action, Report report) {
    SortedSet<String> before = held.held(action.robot());
    held.observe(action);
    SortedSet<String> after = held.held(action.robot());
    hasChanged |= !before.equals(after);
    if (!before.containsAll(after)) {
      granted(action, after, report);
    }
  }

  private void granted(TraceEvent event, SortedSet<String> zones, Report report) {
    report.checked(MUX);
    for (RobotId other : held.holders()) {
      SortedSet<String> both = Sections.common(zones, held.held(other));
      if (!other.equals(event.robot()) && !both.isEmpty()) {
        List<RobotId> robots = List.of(other, event.robot());
        report.violated(MUX, event.timeNs(), robots, "both hold " + both);
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    checkUntil(endNs, report);
    check(endNs, report);
  }

  private void checkUntil(long timeNs, Report report) {
    while (checkedNs < timeNs) {
      check(checkedNs, report);
      boolean anyMoves = bodies.isAnyMoving();
      checkedNs = anyMoves ? Math.min(checkedNs + STEP_NS, timeNs) : timeNs;
    }
  }

  private void check(long timeNs, Report report) {
    report.checked(SAFETY);
    report.checked(HELD);
    if (hasChanged || timeNs >= sufficientUntilNs) {
      look(timeNs, report);
    }
  }

  private void look(long timeNs, Report report) {
    if (hasChanged) {
      zones.forEach(zone -> zone.occupants().removeIf(robot -> !bodies.isOnFloor(robot)));
    }
    sufficientUntilNs = Long.MAX_VALUE;
    clearances.forEach((robot, clearance) -> {
      if (hasChanged || clearance.isUsedUp(timeNs)) {
        Point at = bodies.poseAt(robot, timeNs).at();
        clearance.measured(at, check(robot, at, timeNs, report), timeNs);
      }
      sufficientUntilNs = Math.min(sufficientUntilNs, clearance.sufficesUntilNs());
    });
    hasChanged = false;
  }

  /** Returns how far the body is from the edge of the nearest zone. */
  private double check(RobotId robot, Point at, long timeNs, Report report) {
    double radiusMm = bodies.radiusMm(robot);
    double wayMm = Double.POSITIVE_INFINITY;
    for (Zone zone : zones) {
      double distanceMm = zone.region().distanceMm(at) - radiusMm;
      if (distanceMm < 0) {
        occupies(robot, zone, at, timeNs, report);
      } else {
        zone.occupants().remove(robot);
      }
      wayMm = Math.min(wayMm, Math.abs(distanceMm));
    }
    return wayMm;
  }

  private void occupies(RobotId robot, Zone zone, Point at, long timeNs, Report report) {
    boolean isNew = !zone.occupants().contains(robot);
    if (isNew) {
      zone.occupants().add(robot);
      if (zone.occupants().size() > 1) {
        String detail = "all of them are in zone " + zone.name();
        List<RobotId> robots = zone.occupants().stream().sorted().collect(Collectors.toList());
        report.violatedIn(zone.region(), SAFETY, timeNs, robots, detail);
      }
    }
    if ((isNew || hasChanged)
        && !held.holds(robot, zone.name())
        && reported.add(robot + " " + zone.name())) {
      String where = "(" + Math.round(at.xMm()) + ", " + Math.round(at.yMm()) + ") mm";
      String detail = "is in zone " + zone.name() + " around " + where;
      report.violatedIn(
          zone.region(), HELD, timeNs, List.of(robot), detail + " and holds " + held.held(robot));
    }
  }
}

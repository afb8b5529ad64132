package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.RobotId;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.spec.Bodies;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/**
 * {@code traffic_safety} (paper, section 3): no two cars occupy the same zone at the same time. A
 * car occupies a zone while any part of its true body is inside; what it believes does not count.
 *
 * <p>Also {@code occupied_is_held}: whoever occupies a zone holds it. This is the reason why {@code
 * traffic_safety} follows from {@code Inv_mux_safety}, and it tells of a zone given back too early
 * even if nobody else happens to enter it.
 *
 * <p>Bodies are looked at every 10 ms of movement: at 250 mm/s a body may go 2.5 mm into a zone
 * unseen.
 */
final class TrafficSafety implements Monitor {

  private static final String SAFETY = "traffic_safety";
  private static final String HELD = "occupied_is_held";
  private static final long STEP_NS = 10_000_000;

  private final SortedMap<String, Region> zones;
  private final Bodies bodies = new Bodies();
  private final HeldZones held = new HeldZones();
  private final Map<String, SortedSet<RobotId>> occupants = new TreeMap<>();
  private final SortedSet<String> told = new TreeSet<>();
  private long seenNs;

  TrafficSafety(SortedMap<String, Region> zones) {
    this.zones = zones;
  }

  @Override
  public List<String> lemmas() {
    return List.of(SAFETY, HELD);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    lookUntil(event.timeNs(), report);
    bodies.observe(event);
    held.observe(event);
  }

  @Override
  public void finish(long endNs, Report report) {
    lookUntil(endNs, report);
    lookAt(endNs, report);
  }

  private void lookUntil(long timeNs, Report report) {
    while (seenNs < timeNs) {
      lookAt(seenNs, report);
      seenNs = anybodyMoves() ? Math.min(seenNs + STEP_NS, timeNs) : timeNs;
    }
  }

  private boolean anybodyMoves() {
    for (RobotId robot : bodies.robots()) {
      if (bodies.isMoving(robot)) {
        return true;
      }
    }
    return false;
  }

  private void lookAt(long timeNs, Report report) {
    report.checked(SAFETY);
    report.checked(HELD);
    for (SortedSet<RobotId> gone : occupants.values()) {
      gone.removeIf(robot -> !bodies.isOnFloor(robot));
    }
    for (RobotId robot : bodies.robots()) {
      Point at = bodies.poseAt(robot, timeNs).at();
      double radiusMm = bodies.radiusMm(robot);
      for (Map.Entry<String, Region> zone : zones.entrySet()) {
        boolean inside = zone.getValue().distanceMm(at) < radiusMm;
        SortedSet<RobotId> inZone =
            occupants.computeIfAbsent(zone.getKey(), name -> new TreeSet<>());
        if (!inside) {
          inZone.remove(robot);
        } else {
          if (inZone.add(robot)) {
            entered(zone.getKey(), inZone, timeNs, report);
          }
          checkHeld(zone.getKey(), robot, at, timeNs, report);
        }
      }
    }
  }

  private static void entered(String zone, SortedSet<RobotId> inZone, long timeNs, Report report) {
    if (inZone.size() > 1) {
      report.violated(SAFETY, timeNs, new ArrayList<>(inZone), "all of them are in zone " + zone);
    }
  }

  private void checkHeld(String zone, RobotId robot, Point at, long timeNs, Report report) {
    if (!held.held(robot).contains(zone) && told.add(robot + " " + zone)) {
      report.violated(
          HELD,
          timeNs,
          List.of(robot),
          "is in zone "
              + zone
              + " around ("
              + Math.round(at.xMm())
              + ", "
              + Math.round(at.yMm())
              + ") mm and holds "
              + held.held(robot));
    }
  }
}

package org.starl.apps.intersection.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/**
 * {@code traffic_safety} (paper, section 3): no two cars occupy the same zone at the same time, nor
 * the same place of an arm. A car occupies a zone while any part of its true body is inside; what it believes does not count.
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

  private final List<Zone> zones = new ArrayList<>();
  private final Bodies bodies = new Bodies();
  private final HeldZones held = new HeldZones();
  private final SortedSet<String> told = new TreeSet<>();
  private long seenNs;

  private record Zone(String name, Region region, SortedSet<RobotId> occupants) {}

  TrafficSafety(SortedMap<String, Region> zones) {
    zones.forEach((name, region) -> this.zones.add(new Zone(name, region, new TreeSet<>())));
  }

  @Override
  public List<String> lemmas() {
    return List.of(SAFETY, HELD);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case SAFETY -> "No two cars are in one zone at the same time, with any part of their bodies.";
      case HELD -> "A car that is in a zone, with any part of its body, holds that zone.";
      default -> "";
    };
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
    for (Zone zone : zones) {
      zone.occupants().removeIf(robot -> !bodies.isOnFloor(robot));
    }
    for (RobotId robot : bodies.robots()) {
      Point at = bodies.poseAt(robot, timeNs).at();
      double radiusMm = bodies.radiusMm(robot);
      for (Zone zone : zones) {
        if (zone.region().distanceMm(at) < radiusMm) {
          if (zone.occupants().add(robot)) {
            entered(zone, timeNs, report);
          }
          checkHeld(zone.name(), robot, at, timeNs, report);
        } else if (!zone.occupants().isEmpty()) {
          zone.occupants().remove(robot);
        }
      }
    }
  }

  private static void entered(Zone zone, long timeNs, Report report) {
    if (zone.occupants().size() > 1) {
      report.violated(
          SAFETY,
          timeNs,
          new ArrayList<>(zone.occupants()),
          "all of them are in zone " + zone.name());
    }
  }

  private void checkHeld(String zone, RobotId robot, Point at, long timeNs, Report report) {
    if (!held.holds(robot, zone) && told.add(robot + " " + zone)) {
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

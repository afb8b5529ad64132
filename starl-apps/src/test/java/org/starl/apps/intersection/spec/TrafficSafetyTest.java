package org.starl.apps.intersection.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport.Violation;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;

/** The monitor's shortcuts change no result: poses are computed here at each millisecond. */
class TrafficSafetyTest {

  private static final double RADIUS_MM = 165;
  private static final long STEP_NS = 10 * Time.NS_PER_MS;
  private static final SortedMap<String, ? extends Region> ZONES = Crossing.regions(0);

  @Property(tries = 200)
  void bodiesInOneZoneAreSeenWithin10Ms(
      @ForAll @Size(min = 1, max = 12) List<@DoubleRange(min = -1, max = 1) Double> draws,
      @ForAll @IntRange(min = 1_200, max = 3_200) int x,
      @ForAll @IntRange(min = 1_200, max = 3_200) int y) {
    List<Body> bodies =
        List.of(new Body("bot0", new Point(1_900, 2_000)), new Body("bot1", new Point(x, y)));
    for (int i = 0; i < draws.size(); i++) {
      double draw = draws.get(i);
      // Each third part is a stop.
      double mmPerS = i % 3 == 2 ? 0 : 250 * draw;
      bodies.get(i % 2).drive(1 + Math.abs((int) (1_900 * draw)), mmPerS, 2 * draw * (i % 2));
    }
    long endNs = bodies.stream().mapToLong(body -> body.nowNs).max().orElseThrow();

    List<TraceEvent> events = new ArrayList<>();
    bodies.forEach(body -> events.addAll(body.events));
    events.sort(Comparator.comparingLong(TraceEvent::timeNs));
    Monitors monitors = new Monitors(List.of(new TrafficSafety(ZONES)));
    events.forEach(monitors::observe);
    monitors.finish(endNs);

    TreeSet<Long> reported = new TreeSet<>();
    for (Violation violation : monitors.report().violations()) {
      if (violation.lemma().equals("intersection.traffic_safety")) {
        reported.add(violation.timeNs());
        assertThat(sharedAt(bodies, violation.timeNs())).as("%s", violation).isNotEmpty();
      }
    }
    Map<String, Long> sharedSinceNs = new TreeMap<>();
    for (long nowNs = 0; nowNs <= endNs; nowNs += Time.NS_PER_MS) {
      TreeSet<String> shared = sharedAt(bodies, nowNs);
      sharedSinceNs.keySet().retainAll(shared);
      for (String zone : shared) {
        long sinceNs = sharedSinceNs.merge(zone, nowNs, Math::min);
        if (nowNs - sinceNs > STEP_NS) {
          assertThat(reported.subSet(sinceNs - STEP_NS, true, nowNs, true))
              .as("both are in %s since %d ns", zone, sinceNs)
              .isNotEmpty();
        }
      }
    }
  }

  /** The zones in which both bodies are. */
  private static TreeSet<String> sharedAt(List<Body> bodies, long timeNs) {
    TreeSet<String> shared = new TreeSet<>();
    ZONES.forEach((name, region) -> {
      if (bodies.stream().allMatch(body -> region.distanceMm(body.at(timeNs)) < RADIUS_MM)) {
        shared.add(name);
      }
    });
    return shared;
  }

  /** A body and its way, arc by arc. */
  private static final class Body {
    private final RobotId id;
    private final TreeMap<Long, Moved> moves = new TreeMap<>();
    private final List<TraceEvent> events = new ArrayList<>();
    private Pose pose;
    private long nowNs;

    Body(String name, Point at) {
      id = new RobotId(name);
      pose = Pose.of(at, 0);
      events.add(new Joined(0, id, pose, RADIUS_MM));
      moves.put(0L, new Moved(0, id, pose, 0, 0));
    }

    void drive(int ms, double mmPerS, double radPerS) {
      start(mmPerS, radPerS);
      pose = Kinematics.after(pose, mmPerS, radPerS, ms / 1_000.0);
      nowNs += ms * Time.NS_PER_MS;
      start(0, 0);
    }

    private void start(double mmPerS, double radPerS) {
      Moved moved = new Moved(nowNs, id, pose, mmPerS, radPerS);
      moves.put(nowNs, moved);
      events.add(moved);
    }

    Point at(long timeNs) {
      Moved moved = moves.floorEntry(timeNs).getValue();
      double seconds = (timeNs - moved.timeNs()) / (double) Time.NS_PER_S;
      return Kinematics.after(moved.pose(), moved.linearMmPerS(), moved.angularRadPerS(), seconds)
          .at();
    }
  }
}

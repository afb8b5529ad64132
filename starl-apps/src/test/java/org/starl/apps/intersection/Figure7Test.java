package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.HeldSections;
import org.starl.sim.SimObserver;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;

/** Which cars are inside, or hold zones, at the same time in Figure 7 (paper, section 5.3). */
class Figure7Test {

  private static final int SEEDS = 12;
  private static final SortedSet<String> INSIDE = new TreeSet<>();
  private static final SortedSet<String> HOLDING = new TreeSet<>();

  /** Notes which two cars are inside, or hold zones, at the same time. */
  private static final class Together implements SimObserver {
    private final Bodies bodies = new Bodies();
    private final HeldSections zones = new HeldSections();

    @Override
    public void observed(TraceEvent event) {
      bodies.observe(event);
      zones.observe(event);
      for (RobotId a : bodies.robots()) {
        for (RobotId b : bodies.robots()) {
          if (isInside(a, event.timeNs()) && isInside(b, event.timeNs())) {
            INSIDE.add(a + " " + b);
          }
          HOLDING.add(a + zones.held(a).toString() + " " + b + zones.held(b));
        }
      }
    }

    private boolean isInside(RobotId robot, long timeNs) {
      Point at = bodies.poseAt(robot, timeNs).at();
      return Crossing.zoneAt(at).isPresent();
    }
  }

  @BeforeAll
  static void runSomeSeeds() {
    for (long seed = 1; seed <= SEEDS; seed++) {
      IntersectionTest.run(
          IntersectionTest.request(seed, 0, Map.of("scenario", "figure7", "debris", "0")),
          Map.of(),
          new Together());
    }
  }

  @Test
  void robots1And2AreInsideTogether() {
    assertThat(INSIDE).contains("bot1 bot2");
  }

  @Test
  void rightTurnersDoNotWaitForEachOther() {
    assertThat(INSIDE).contains("bot0 bot3");
    assertThat(HOLDING).contains("bot0[C, C1] bot3[A, A1]");
  }

  @Test
  void routesWithNoZoneInCommonAreHeldTogether() {
    assertThat(HOLDING).contains("bot1[B, B1, D] bot3[A, A1]");
  }

  @Test
  void routesWithAZoneInCommonAreNotHeldTogether() {
    assertThat(HOLDING).doesNotContain("bot1[B, B1, D] bot2[A, B, C, C1]");
  }
}

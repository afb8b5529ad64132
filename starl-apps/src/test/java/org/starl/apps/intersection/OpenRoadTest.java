package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Plan;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.robot.Floor;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/** Cars arrive and leave; all specifications are checked, including progress with its bounds. */
@Tag("long")
class OpenRoadTest {

  private static final long SECOND_NS = 1_000_000_000;

  /** Records which robots are on the floor, and how often cars were stopped. */
  private static final class Floor implements SimObserver {
    private final SortedSet<RobotId> onFloor = new TreeSet<>();
    private final SortedSet<RobotId> came = new TreeSet<>();
    private int most;
    private final Bodies bodies = new Bodies();
    private int stopped;
    private int crowded;
    private long lastJoinedNs;

    @Override
    public void observed(TraceEvent event) {
      if (event instanceof TraceEvent.Joined joined) {
        crowded += isAlone(joined) ? 0 : 1;
      }
      bodies.observe(event);
      if (event instanceof TraceEvent.Joined joined) {
        onFloor.add(joined.robot());
        came.add(joined.robot());
        most = Math.max(most, onFloor.size());
        lastJoinedNs = joined.timeNs();
      } else if (event instanceof TraceEvent.Left left) {
        onFloor.remove(left.robot());
      } else if (event instanceof Variable v && v.of(MotionFact.FLAG) == MotionFlag.FAIL) {
        stopped++;
      }
    }

    /** Whether no other body is in the place in which a car appears. */
    private boolean isAlone(TraceEvent.Joined joined) {
      for (Zone arm : Zone.values()) {
        Region edge = Crossing.region(Crossing.placeName(arm, Crossing.PLACES - 1));
        for (RobotId other : bodies.robots()) {
          Point at = bodies.poseAt(other, joined.timeNs()).at();
          if (edge.contains(joined.pose().at()) && edge.distanceMm(at) < joined.radiusMm()) {
            return false;
          }
        }
      }
      return true;
    }
  }

  private static Plan plan(long seed, String arrivals, Map<String, String> settings) {
    var request = IntersectionTest.request(seed, 0, Map.of("arrivals", arrivals, "debris", "0"));
    IntersectionDemo demo = new IntersectionDemo();
    SimSettings.Builder builder = demo.defaultSettings(request).set("duration", "60s");
    settings.forEach(builder::set);
    return demo.plan(request, builder.build());
  }

  private static SimResult run(Plan plan, long seed, SimObserver observer) {
    SimResult result = plan.simulation().observer(observer).seed(seed).build().run();
    String story = "seed " + seed + "\n" + String.join("\n", plan.story().lines());
    assertThat(result.spec().violations()).as(story).isEmpty();
    assertThat(result.unfinished()).as(story).isEmpty();
    return result;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void everyCarThatEntersCrossesAndLeaves(long seed) {
    Plan plan = plan(seed, "8/min", Map.of("duration", "120s"));
    Floor floor = new Floor();
    SimResult result = run(plan, seed, floor);
    // The roadside units leave after the last car.
    assertThat(floor.onFloor).isEmpty();
    int cars = floor.came.size() - 3;
    assertThat(plan.story().measures().came()).isEqualTo(cars);
    assertThat(plan.story().measures().completed()).isEqualTo(cars).isGreaterThan(5);
    assertThat(result.results()).hasSize(cars);
    assertThat(floor.lastJoinedNs).isLessThan(120 * SECOND_NS);
    assertThat(floor.stopped).as("no car runs into another").isZero();
  }

  @ParameterizedTest
  @ValueSource(longs = {4, 5})
  void lostAndLateMessagesOnlyCostTime(long seed) {
    Plan plan =
        plan(seed, "20/min", Map.of("messageLoss", "0.3", "messageDelay", "uniform(10ms,200ms)"));
    Floor floor = new Floor();
    run(plan, seed, floor);
    assertThat(floor.stopped).as("no car runs into another").isZero();
  }

  @Test
  void carsWaitBeyondTheEdgeIfMoreArriveThanCanCross() {
    Plan plan = plan(6, "60/min", Map.of());
    Floor floor = new Floor();
    run(plan, 6, floor);
    Map<String, Double> figures = plan.story().measures().figures();
    assertThat(figures.get("turned_away")).isGreaterThan(10);
    assertThat(figures.get("arrived") - figures.get("turned_away"))
        .isEqualTo(plan.story().measures().came());
    // On each arm three, and some that cross or leave.
    assertThat(floor.most - 3).isBetween(12, 20);
    assertThat(figures.get("longest_queue")).isGreaterThan(5);
    assertThat(floor.crowded).as("no car appears in an occupied place").isZero();
    assertThat(floor.stopped).as("no car runs into another").isZero();
  }

  @Test
  void inexactPositionsAreSafe() {
    run(plan(7, "20/min", Map.of("positionNoise", "60mm")), 7, new Floor());
  }

  @Test
  void idealMotionIsSafe() {
    run(plan(8, "20/min", Map.of("idealMotion", "true")), 8, new Floor());
  }

  @ParameterizedTest
  @ValueSource(longs = {10, 11, 12})
  void aRestartedProgramContinuesFromWhereItsCarStands(long seed) {
    Plan plan = plan(seed, "12/min", Map.of("chaos", "moving", "chaosFor", "60s"));
    run(plan, seed, new Floor());
    assertThat(plan.story().measures().completed()).isGreaterThan(4);
  }

  @Test
  void aDeadCarIsTowedAndTheOthersContinue() {
    Plan plan =
        plan(
            13,
            "12/min",
            Map.of("faults", "crash(any,at=25s); crash(any,at=32s); crash(any,at=40s)"));
    run(plan, 13, new Floor());
    Map<String, Double> figures = plan.story().measures().figures();
    assertThat(figures.get("towed")).isPositive();
    assertThat(figures.get("crossed") + figures.get("towed"))
        .isEqualTo(plan.story().measures().came());
  }

  @Test
  void aRunWithoutArrivalsEnds() {
    Plan plan = plan(9, "1/h", Map.of());
    SimResult result = run(plan, 9, new Floor());
    assertThat(plan.story().measures().came()).isZero();
    assertThat(result.endNs()).isEqualTo(60 * SECOND_NS);
  }
}

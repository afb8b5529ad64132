package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.IntersectionApp;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.Floor;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.spec.Bodies;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/**
 * Two cars whose registrations and mutexes know nothing of each other, as after a fault that made each
 * believe that a zone is its own: they bump into each other in it.
 */
class ContactTest {

  private static final int SEEDS = 10;

  /** A contact stops a body up to 1 mm before the other one. */
  private static final double TOUCH_MM = 2;

  /** The contacts of two bodies. */
  private static final class Contacts implements SimObserver {
    private final Bodies bodies = new Bodies();
    private int count;
    private long sinceNs = -1;
    private long longestNs;

    @Override
    public void observed(TraceEvent event) {
      bodies.observe(event);
      long nowNs = event.timeNs();
      boolean touch = bodies.robots().size() == 2 && gapMm(nowNs) < TOUCH_MM;
      if (touch && sinceNs < 0) {
        count++;
        sinceNs = nowNs;
      }
      longestNs = sinceNs < 0 ? longestNs : Math.max(longestNs, nowNs - sinceNs);
      sinceNs = touch ? sinceNs : -1;
    }

    private double gapMm(long nowNs) {
      RobotId one = bodies.robots().iterator().next();
      double gapMm = Double.POSITIVE_INFINITY;
      for (RobotId other : bodies.robots()) {
        if (!other.equals(one)) {
          double distanceMm =
              bodies.poseAt(one, nowNs).at().distanceMm(bodies.poseAt(other, nowNs).at());
          gapMm = distanceMm - bodies.radiusMm(one) - bodies.radiusMm(other);
        }
      }
      return gapMm;
    }
  }

  private static SimSettings settings() {
    return SimSettings.builder()
        .set(Setting.FLOOR_HEIGHT, SimSettings.defaults().get(Setting.FLOOR_WIDTH))
        .set("duration", "300s")
        .build();
  }

  private static RobotSpec alone(String route, String name) {
    Car car = Car.on(Route.parse(route).orElseThrow(), 0, name, 0);
    return new RobotSpec(
        car.id(),
        car.start(),
        true,
        gvh -> new IntersectionApp(gvh, name, car.trip(), Participants.of(car.id())));
  }

  @ParameterizedTest
  @CsvSource({"A0 A C C1, C0 C D D1", "A0 A C C1, C0 C D B B1", "D0 D B A A1, B0 B A C C1"})
  void twoCarsThatBumpBackAwayFromEachOtherAndCross(String one, String other) {
    int count = 0;
    // A slow start lets the other car come into the first one's zone.
    for (long seed = 1; seed <= SEEDS; seed++) {
      Contacts contacts = new Contacts();
      SimResult result =
          Simulation.builder()
              .settings(settings())
              .obstacles(Floor.kerbs())
              .robot(alone(one, "bot0"))
              .robot(alone(other, "bot1"))
              .observer(contacts)
              .fault("slow(bot1,0.1,at=0s,for=" + seed / 2.0 + "s)")
              .seed(seed)
              .build()
              .run();
      assertThat(result.unfinished()).as("seed %d", seed).isEmpty();
      assertThat(contacts.longestNs).as("seed %d", seed).isLessThan(2 * Time.NS_PER_S);
      count += contacts.count;
    }
    assertThat(count).as("contacts").isPositive();
  }

  /** When a car's motion failed, and how soon after that it drove again. */
  private static final class Retries implements SimObserver {
    private long failedNs = -1;
    private long soonestNs = Long.MAX_VALUE;

    @Override
    public void observed(TraceEvent event) {
      if (event instanceof TraceEvent.Action action) {
        if (action.fact() instanceof MotionFact.failed) {
          failedNs = event.timeNs();
        } else if (action.fact() instanceof MotionFact.doMove && failedNs >= 0) {
          soonestNs = Math.min(soonestNs, event.timeNs() - failedNs);
          failedNs = -1;
        }
      }
    }
  }

  @Test
  void aFlowingCarWaitsAfterABump() {
    Car car = Car.on(Route.parse("A0 A C C1").orElseThrow(), 0, "bot0", 0);
    Point debris = Crossing.centre(Zone.C);
    List<Point> corners = Rectangle.around(debris, 60, 60).outline().vertices();
    Obstacles floor = Floor.kerbs().plus(new Obstacle(corners, true, true, 40_000));
    Retries retries = new Retries();
    new IntersectionPlan(floor, settings(), CarProgram.FLOW)
        .closed(List.of(car))
        .simulation()
        .observer(retries)
        .build()
        .run();
    assertThat(retries.soonestNs).isBetween(Time.NS_PER_S, 10 * Time.NS_PER_S);
  }

  /** The car bumps where it has just released the zone behind it, less than 100 mm before its body. */
  @ParameterizedTest
  @ValueSource(ints = {-10, -5, 0, 5, 10})
  void aCarBacksIntoNoZoneThatItHasReleased(int beyondMm) {
    SimSettings settings = settings();
    Car car = Car.on(Route.parse("A0 A C C1").orElseThrow(), 0, "bot0", 0);
    double aheadMm = settings.robotRadiusMm() + 30 + beyondMm;
    Point debris = Crossing.centre(Zone.C).minus(new Point(0, aheadMm));
    List<Point> corners = Rectangle.around(debris, 60, 60).outline().vertices();
    Obstacles floor = Floor.kerbs().plus(new Obstacle(corners, true, true, 20_000));
    SimResult result =
        new IntersectionPlan(floor, settings, CarProgram.PAPER)
            .closed(List.of(car))
            .simulation()
            .build()
            .run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.unfinished()).isEmpty();
    assertThat(result.endNs()).as("held up").isGreaterThan(20 * Time.NS_PER_S);
  }
}

package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.apps.Request;
import org.starl.apps.intersection.robot.IntersectionFactory;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;

/** Scenarios and worlds other than the default. */
class ScenariosTest {

  /** Records where each body was put on the floor, and how often it started to move. */
  private static final class Parking implements SimObserver {
    private final SortedMap<RobotId, Integer> moves = new TreeMap<>();
    private final SortedMap<RobotId, Point> left = new TreeMap<>();
    private final SortedMap<RobotId, Point> came = new TreeMap<>();

    @Override
    public void observed(TraceEvent event) {
      if (event instanceof TraceEvent.Joined joined) {
        came.put(joined.robot(), joined.pose().at());
        moves.put(joined.robot(), 0);
      } else if (event instanceof TraceEvent.Moved moved) {
        moves.merge(moved.robot(), moved.linearMmPerS() == 0 ? 0 : 1, Integer::sum);
      } else if (event instanceof TraceEvent.Left gone) {
        left.put(gone.robot(), came.getOrDefault(gone.robot(), new Point(0, 0)));
      }
    }
  }

  @Test
  void chaosPutsHalfOfTheSeedsOnAnOpenRoadAndSomeWithThePapersCars() {
    IntersectionDemo demo = new IntersectionDemo();
    int open = 0;
    Map<String, Integer> cars = new TreeMap<>();
    for (long seed = 1; seed <= 100; seed++) {
      Request varied =
          demo.varied(new Request(seed, OptionalInt.empty(), demo.defaults(), Set.of()));
      boolean isOpen = !varied.parameter(IntersectionFactory.ARRIVALS.key()).isEmpty();
      open += isOpen ? 1 : 0;
      String car = varied.parameter(IntersectionFactory.CAR.key());
      assertThat(isOpen && !car.equals("flow")).as("seed %d", seed).isFalse();
      cars.merge(car, 1, Integer::sum);
      assertThat(varied.robots().orElseThrow()).isBetween(2, 12);
    }
    assertThat(open).isBetween(30, 70);
    assertThat(cars.get("paper")).isBetween(5, 25);
    assertThat(cars.get("program")).isBetween(5, 25);
  }

  private static Path originals() {
    // A relative property counts from the folder above the modules, as the default does.
    String shared = System.getProperty("starl.shared", "../../shared");
    Path folder = Path.of(shared, "data", "starl-original", "intersection");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (set -Dstarl.shared)");
    return folder;
  }

  @Test
  void theOriginalsFilesAreSafeAndLive() {
    Parking parking = new Parking();
    Map<String, String> parameters =
        Map.of("scenario", "legacy", "files", originals().toString(), "debris", "0");
    IntersectionTest.run(IntersectionTest.request(3, 0, parameters), Map.of(), parking);
    assertThat(parking.moves).hasSize(5);
    RobotId parked = parking.moves.lastKey();
    assertThat(parking.moves.get(parked)).as("%s is parked", parked).isZero();
    assertThat(parking.moves.headMap(parked).values()).allMatch(moves -> moves > 0);
    assertThat(parking.left).hasSize(4).doesNotContainKey(parked);
  }

  @Test
  void inexactPositionsAreSafe() {
    for (long seed = 1; seed <= 3; seed++) {
      IntersectionTest.run(
          IntersectionTest.request(seed, 4, Map.of()), Map.of("positionNoise", "20mm"));
    }
  }

  @Test
  void idealMotionIsSafe() {
    IntersectionTest.run(IntersectionTest.request(2, 6, Map.of()), Map.of("idealMotion", "true"));
  }

  @Test
  void debrisOnlyCostsTime() {
    Map<String, String> parameters = Map.of("debris", "8");
    IntersectionTest.run(IntersectionTest.request(4, 6, parameters), Map.of());
  }

  @Test
  void oneCarAloneCrosses() {
    IntersectionTest.run(IntersectionTest.request(1, 1, Map.of()), Map.of());
  }
}

package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.apps.intersection.robot.Floor;
import org.starl.apps.intersection.spec.IntersectionSpec;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** Simulates faulty cars: the specifications must report each planted bug. */
class BuggyCarsTest {

  private static final int SEEDS = 20;
  private static final int CARS = 6;

  private static SimResult run(BuggyCar.Fault fault, long seed) {
    SimSettings settings =
        SimSettings.builder()
            .set(Setting.FLOOR_HEIGHT, SimSettings.defaults().get(Setting.FLOOR_WIDTH))
            .duration(Duration.ofSeconds(fault == BuggyCar.Fault.NEVER_LEAVES ? 1800 : 60))
            .build();
    List<Car> cars = Car.drawn(settings.robotName(), CARS, new Rng(seed).fork("cars"));
    Traffic traffic = new Traffic(settings.robotRadiusMm(), cars);
    Simulation.Builder simulation =
        new IntersectionPlan(Floor.kerbs(), settings, CarProgram.PAPER)
            .simulation(
                new IntersectionSpec(
                    IntersectionPlan.deltaNs(settings), CARS, 0, IntersectionSpec.STOPPING_NS))
            .seed(seed)
            .director(traffic)
            .observer(traffic);
    for (Car car : cars) {
      simulation.robot(
          new RobotSpec(car.id(), car.start(), false, gvh -> new BuggyCar(gvh, car.trip(), fault)));
    }
    return simulation.build().run();
  }

  @ParameterizedTest
  @CsvSource({
    "DOES_NOT_ASK, intersection.Inv_list_crit",
    "DOES_NOT_ASK, intersection.traffic_safety",
    "GRANTS_ITSELF, intersection.Inv_mux_safety",
    "GRANTS_ITSELF, mutex.Exclusive",
    "RELEASES_TOO_EARLY, intersection.occupied_is_held",
    "NEVER_LEAVES, intersection.traffic_progress",
  })
  void aBuggyCarIsSeen(BuggyCar.Fault fault, String lemma) {
    long seed = 0;
    SimResult result;
    do {
      seed++;
      result = run(fault, seed);
    } while (result.spec().violations(lemma) == 0 && seed < SEEDS);
    assertThat(result.spec().violations(lemma)).as("%s, seeds 1..%d", fault, SEEDS).isPositive();
  }
}

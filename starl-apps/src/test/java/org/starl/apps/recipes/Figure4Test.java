package org.starl.apps.recipes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;

/** The paper's Figure 4 compiles, and behaves as printed. */
class Figure4Test {

  private static final double LANE_MM = 400;
  private static final double FAR_MM = 1600;
  private static final double HALF_TURN = Math.PI;

  private static ItemPosition at(String name, double xMm, double yMm) {
    return new ItemPosition(name, xMm, yMm);
  }

  // Four cars go straight, one from each side; each two neighbours have one zone in common.
  private static final ItemPosition A = at("A", -LANE_MM, LANE_MM);
  private static final ItemPosition B = at("B", LANE_MM, LANE_MM);
  private static final ItemPosition C = at("C", -LANE_MM, -LANE_MM);
  private static final ItemPosition D = at("D", LANE_MM, -LANE_MM);

  private static Simulation.Builder crossing(long seed) {
    return Simulation.builder()
        .name("figure4")
        .seed(seed)
        .robot(
            car(0, new Pose(-LANE_MM, FAR_MM, -HALF_TURN / 2), A, C, at("C1", -LANE_MM, -FAR_MM)))
        .robot(car(1, new Pose(-FAR_MM, -LANE_MM, 0), C, D, at("D1", FAR_MM, -LANE_MM)))
        .robot(car(2, new Pose(LANE_MM, -FAR_MM, HALF_TURN / 2), D, B, at("B1", LANE_MM, FAR_MM)))
        .robot(car(3, new Pose(FAR_MM, LANE_MM, HALF_TURN), B, A, at("A1", -FAR_MM, LANE_MM)))
        .monitor(MutexSpec::new)
        .monitor(RegistrationSpec::new);
  }

  private static RobotSpec car(int number, Pose start, ItemPosition... path) {
    return new RobotSpec(
        new RobotId("bot" + number), start, true, gvh -> new Figure4(gvh, List.of(path)));
  }

  @Test
  void fourCarsCrossAndUnregister() {
    for (long seed = 1; seed <= 20; seed++) {
      SimResult result = crossing(seed).build().run();
      assertThat(result.isFinished()).as("seed %d: %s", seed, result.unfinished()).isTrue();
      assertThat(result.spec().holds()).as("seed %d: %s", seed, result.spec()).isTrue();
      assertThat(result.results().values()).hasSize(4);
      assertThat(result.results().values())
          .allSatisfy(ended -> assertThat(ended).asString().isEqualTo("[DONE, true]"));
    }
  }
}

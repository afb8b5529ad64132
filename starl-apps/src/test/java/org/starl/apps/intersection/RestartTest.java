package org.starl.apps.intersection;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.intersection.logic.Route;
import org.starl.apps.intersection.robot.Car;
import org.starl.apps.intersection.robot.CarProgram;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** Cars whose programs begin anew in the middle of the crossing. */
class RestartTest {

  private static final Car CAR = Car.on(Route.parse("D0 D B A A1").orElseThrow(), 0, "car", 0);

  /** The car's program crashes at this place, on its arc from D to B, and begins anew. */
  private static SimResult restartsAt(double yMm, String reaction) {
    SimSettings settings =
        SimSettings.builder()
            .set(Setting.FLOOR_HEIGHT, SimSettings.defaults().get(Setting.FLOOR_WIDTH))
            .set(Setting.REACTION.key(), reaction)
            .set("duration", "120s")
            .build();
    return Simulation.builder()
        .settings(settings)
        .seed(1)
        .robot(
            new RobotSpec(
                CAR.id(),
                new Pose(2674.255, yMm, 0.886),
                true,
                gvh -> CarProgram.FLOW.of(gvh, CAR.trip(), Participants.of(CAR.id()))))
        .fault("crash(car,at=1ms,restart=100ms)")
        .build()
        .run();
  }

  @ParameterizedTest
  @ValueSource(strings = {"0ms", "150ms"})
  void aCarThatHasJustLeftAZoneDrivesOnFromBesideIt(String reaction) {
    List<Double> stuck =
        IntStream.range(0, 40)
            .mapToObj(i -> 2_665 + 0.01 + i * (i < 20 ? 0.01 : 0.25))
            .filter(yMm -> !restartsAt(yMm, reaction).isFinished())
            .toList();
    assertThat(stuck).isEmpty();
  }

  @Test
  void aCarInTheMiddleOfAZoneDrivesOn() {
    assertThat(restartsAt(2_750, "0ms").isFinished()).isTrue();
  }
}

package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Sighting;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationFailed;

/** The simulated sensor, read by an app in a simulation. */
class SimObjectsTest extends ObjectSensorContract {

  private static final RobotId BOT = new RobotId("bot0");

  /** An app that returns what it senses at its first fix. */
  private static final class Look extends LogicThread {
    private final double rangeMm;

    Look(GlobalVarHolder gvh, double rangeMm) {
      super(gvh);
      this.rangeMm = rangeMm;
      if (rangeMm >= 0) {
        gvh.plat.objects.require(rangeMm);
      }
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      return List.copyOf(gvh.plat.objects.sensed());
    }
  }

  private static Simulation.Builder simulation(double rangeMm) {
    return Simulation.builder()
        .settings(SimSettings.builder().robotRadius(50.0).build())
        .obstacles(WALL)
        .robot(new RobotSpec(BOT, new Pose(0, 0, 0), true, gvh -> new Look(gvh, rangeMm)));
  }

  @Override
  ObjectSensor sensor(List<ItemPosition> objects) {
    return new ObjectSensor() {
      private double rangeMm = -1;

      @Override
      public void require(double newRangeMm) {
        rangeMm = newRangeMm;
      }

      @Override
      public List<Sighting> sensed() {
        try {
          return simulation(rangeMm)
              .objects(RANGE_MM, objects)
              .build()
              .run()
              .results()
              .get(BOT)
              .stream()
              .map(Sighting.class::cast)
              .toList();
        } catch (SimulationFailed e) {
          throw new IllegalStateException(e.getMessage(), e);
        }
      }
    };
  }

  @Test
  void aRobotWithoutASensorDoesNotStart() {
    assertThatThrownBy(() -> simulation(100).build().run())
        .isInstanceOf(SimulationFailed.class)
        .hasMessageContainingAll("bot0", "this robot has no object sensor");
  }

  @Test
  void aRobotWithASensorOfTooShortARangeDoesNotStart() {
    assertThatThrownBy(() -> simulation(601).objects(600, List.of()).build().run())
        .isInstanceOf(SimulationFailed.class)
        .hasMessageContaining("600 mm: expected at least 601 mm");
  }
}

package org.starl.apps.fleet.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** What a battery of 10 m charges and loses, on one robot. */
class BatteryTest {

  private static final double RANGE_MM = 10_000;

  private interface Part {
    void play(Robot robot, Battery battery);
  }

  private static final class Robot extends LogicThread {
    private final Part part;
    private final double rangeMm;

    Robot(GlobalVarHolder gvh, double rangeMm, Part part) {
      super(gvh);
      this.rangeMm = rangeMm;
      this.part = part;
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      part.play(this, new Battery(gvh, rangeMm));
      return List.of();
    }

    void stand(long ms) {
      sleep(ms);
    }

    /** Drives about 5 m, as far as the goal allows, in less than a minute. */
    void drive() {
      Point at = gvh.gps.pose().at();
      gvh.plat.moat.doMove(new ItemPosition("right", at.xMm() + 5_060, at.yMm()));
      await(() -> !gvh.plat.moat.inMotion());
    }

    boolean isRestarted() {
      return gvh.id.boot() > 1;
    }
  }

  private static void play(double rangeMm, Part part) {
    Simulation.builder()
        .seed(1)
        .settings(
            SimSettings.builder()
                .set("duration", "2000s")
                .set("faults", "crash(bot0,at=1900s,restart=10s)")
                .build())
        .robots(1, gvh -> new Robot(gvh, rangeMm, part))
        .build()
        .run();
  }

  private static int percent(Battery battery) {
    int percent = 0;
    while (percent < 101 && battery.suffices((percent + 1) / 100.0 * RANGE_MM / 1.5)) {
      percent++;
    }
    return percent;
  }

  @Test
  void theChargeFallsWithTimeAndWayAndGrowsAtACharger() {
    List<Integer> seen = new ArrayList<>();
    List<Boolean> full = new ArrayList<>();
    play(
        RANGE_MM,
        (robot, battery) -> {
          if (robot.isRestarted()) {
            seen.add(percent(battery));
            robot.stand(80_000);
            return;
          }
          full.add(battery.isFull());
          robot.stand(720_000); // a fortieth of eight hours
          battery.tick(false);
          seen.add(percent(battery));
          battery.tick(false);
          seen.add(percent(battery));
          full.add(battery.isFull());
          robot.drive();
          battery.tick(false);
          seen.add(percent(battery));
          robot.stand(6_000); // a twentieth of what a full charge takes
          battery.tick(true);
          seen.add(percent(battery));
          robot.stand(56_000);
          battery.tick(true);
          seen.add(percent(battery));
          full.add(battery.isFull());
          robot.stand(10_000);
          battery.tick(true);
          seen.add(percent(battery));
          full.add(battery.isFull());
          robot.stand(720_000);
          battery.tick(false);
          robot.stand(2_000_000);
        });
    assertThat(seen).containsExactly(97, 97, 47, 52, 99, 100, 97);
    assertThat(full).containsExactly(true, false, false, true);
  }

  @Test
  void anEmptyBatteryStaysEmptyAndOneOfNoRangeIsNeverEmpty() {
    play(
        1_000,
        (robot, battery) -> {
          if (!robot.isRestarted()) {
            robot.drive();
            battery.tick(false);
            assertThat(battery.suffices(0.1)).isFalse();
            assertThat(battery.suffices(0)).isTrue();
            robot.stand(60_000);
            battery.tick(true);
            assertThat(battery.suffices(320)).as("half of it").isTrue();
            assertThat(battery.suffices(340)).isFalse();
          }
        });
    play(
        0,
        (robot, battery) -> {
          robot.drive();
          battery.tick(false);
          assertThat(battery.suffices(Double.MAX_VALUE)).isTrue();
          assertThat(battery.isFull()).isTrue();
        });
  }
}

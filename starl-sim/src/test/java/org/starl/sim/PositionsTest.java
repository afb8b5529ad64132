package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Fix;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;

/** The other robots' positions and the waypoints, as {@code gvh.gps} gives them. */
class PositionsTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");
  private static final RobotId BOT2 = new RobotId("bot2");

  /** Looks at the positions after 5 s. */
  private static final class Onlooker extends LogicThread {
    Onlooker(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      List<Object> before = List.of(gvh.gps.getPositions());
      sleep(5_000);
      return List.of(
          before,
          gvh.gps.getPositions(),
          gvh.plat.clock.nowNs(),
          gvh.gps.getWaypointPositions().keySet().toString(),
          gvh.gps.getWaypointPosition("dock") != null,
          gvh.gps.getWaypointPosition("none") == null);
    }
  }

  private static Simulation.Builder onlookers() {
    Simulation.Builder builder =
        Simulation.builder()
            .waypoints(List.of(new ItemPosition("dock", 1, 2), new ItemPosition("bay", 3, 4)))
            .settings(
                SimSettings.builder().positionNoise(20).duration(Duration.ofSeconds(10)).build());
    for (int i = 0; i < 3; i++) {
      Pose start = new Pose(1000.0 * i, 0, 0);
      builder.robot(new RobotSpec(new RobotId("bot" + i), start, true, Onlooker::new));
    }
    return builder;
  }

  // The app returned this map.
  @SuppressWarnings("unchecked")
  private static SortedMap<RobotId, Fix> positions(SimResult result, RobotId robot) {
    return (SortedMap<RobotId, Fix>) result.results().get(robot).get(1);
  }

  private static long ageNs(SimResult result, RobotId reader, RobotId seen) {
    return (long) result.results().get(reader).get(2)
        - positions(result, reader).get(seen).timeNs();
  }

  @Test
  void everyRobotHasTheNewestFixOfEveryRobot() {
    SimResult result = onlookers().build().run();
    for (RobotId reader : List.of(BOT0, BOT1, BOT2)) {
      SortedMap<RobotId, Fix> seen = positions(result, reader);
      assertThat(seen.keySet()).containsExactly(BOT0, BOT1, BOT2);
      for (int i = 0; i < 3; i++) {
        RobotId robot = new RobotId("bot" + i);
        Fix fix = seen.get(robot);
        assertThat(fix.errorMm()).isEqualTo(20);
        assertThat(fix.pose().distanceMm(new Pose(1000.0 * i, 0, 0).at())).isBetween(0.01, 20.0);
        assertThat(ageNs(result, reader, robot)).isBetween(0L, 75_000_000L);
      }
      assertThat(seen).isEqualTo(positions(result, BOT0));
    }
    assertThat(result.results().get(BOT0).get(0)).isEqualTo(List.of(new TreeMap<>()));
  }

  @Test
  void aCrashedRobotKeepsItsLastFix() {
    SimResult result = onlookers().fault("crash(bot1,at=2s)").build().run();
    assertThat(positions(result, BOT0)).containsKey(BOT1);
    assertThat(ageNs(result, BOT0, BOT1)).isBetween(3_000_000_000L, 3_075_000_000L);
  }

  @Test
  void timesAreOnTheReadersClock() {
    SimResult result = onlookers().fault("skew(bot0,2s,at=1s)").build().run();
    assertThat(ageNs(result, BOT0, BOT1)).isBetween(0L, 75_000_000L);
  }

  @Test
  void everyRobotHasTheWaypoints() {
    SimResult result = onlookers().build().run();
    assertThat(result.results().values())
        .allSatisfy(
            ended -> assertThat(ended.subList(3, 6)).isEqualTo(List.of("[bay, dock]", true, true)));
  }

  @Test
  void waypointsOfOneNameAreRefused() {
    ItemPosition dock = new ItemPosition("dock", 1, 2);
    assertThatThrownBy(() -> Simulation.builder().waypoints(List.of(dock, dock)))
        .isInstanceOf(BadInput.class)
        .hasMessage("waypoints: two are called 'dock': expected names that differ");
  }
}

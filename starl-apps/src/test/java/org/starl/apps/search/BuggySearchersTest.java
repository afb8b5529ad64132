package org.starl.apps.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.search.logic.BuggySearcher;
import org.starl.apps.search.logic.Drive;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.apps.search.robot.GeneratedHouse;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** The monitor of its lemma reports each planted bug of {@link BuggySearcher}. */
class BuggySearchersTest {

  private static final int ROBOTS = 3;
  private static final int ROOMS = 2;

  private static SimResult run(BuggySearcher.Fault fault) {
    SimSettings settings = SimSettings.builder().duration(Duration.ofHours(1)).build();
    HousePlan plan = GeneratedHouse.of(ROOMS, ROBOTS, new Rng(1));
    House house =
        House.of(plan, 600, Drive.clearanceMm(settings.motionParameters(0), plan.bounds()));
    Point thing = GeneratedHouse.somewhere(house, new Rng(1));
    Simulation.Builder simulation = Simulation.builder().settings(settings).obstacles(plan.walls());
    if (fault == BuggySearcher.Fault.FORGETS_THE_DEAD || fault == BuggySearcher.Fault.IS_TIMID) {
      simulation.fault("crash(bot1,at=1s)");
    }
    for (Point start : plan.starts()) {
      RobotId robot = new RobotId("bot" + plan.starts().indexOf(start));
      simulation.robot(
          new RobotSpec(robot, Pose.of(start, 0), true, gvh -> new BuggySearcher(gvh, fault)));
    }
    SearchDemo.watch(
        simulation, house, List.of(new ItemPosition("object", thing.xMm(), thing.yMm())), settings);
    return simulation.build().run();
  }

  @ParameterizedTest
  @CsvSource({
    "SEES_THROUGH_WALLS, search.found",
    "DOES_NOT_LOOK, search.nothing",
    "DOES_NOT_LOOK, search.swept",
    "IS_LAZY, search.gave_up",
    "IS_TIMID, search.gave_up",
    "IS_STUBBORN, search.agreed",
    "FORGETS_THE_DEAD, search.assigned",
    "NEVER_ENDS, search.ended",
  })
  void aBuggySearcherIsSeen(BuggySearcher.Fault fault, String lemma) {
    SimResult result = run(fault);
    assertThat(result.spec().violations(lemma)).as("%s", result.spec()).isPositive();
  }
}

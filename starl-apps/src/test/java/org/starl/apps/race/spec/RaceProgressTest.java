package org.starl.apps.race.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.apps.race.logic.RaceFact;
import org.starl.apps.race.logic.RacePoint;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;

/** The progress of a race of two robots on handwritten traces. */
class RaceProgressTest {

  private static final RobotId A = new RobotId("bot0");
  private static final RobotId B = new RobotId("bot1");

  private final Monitors monitors =
      new Monitors(
          List.of(
              new RaceProgress(
                  List.of(new RacePoint("goal", new Point(0, 0), 75)), 0, 0, 1_000_000)));

  RaceProgressTest() {
    for (RobotId robot : List.of(A, B)) {
      monitors.observe(new Joined(0, robot, new Pose(0, 0, 0), 165));
    }
  }

  private void take(long atS, RobotId robot, long claimedNs) {
    RaceFact.Taken taken = new RaceFact.Taken(0, "goal", A, claimedNs, 0);
    monitors.observe(
        Action.of(atS * Time.NS_PER_S, robot, Instance.APP, RaceFact.Taken.SHAPE, taken));
  }

  /** The violations of {@code told} long after the last fault. */
  private long untold() {
    monitors.finish(1_000 * Time.NS_PER_S);
    return monitors.report().violations("race.told");
  }

  @Test
  void aRobotThatKnowsAWorseWinnerOnlyViolatesTold() {
    take(1, A, 1);
    take(2, B, 2);
    assertThat(untold()).isEqualTo(1);
  }

  @Test
  void allRobotsMayKnowABetterWinner() {
    take(1, A, 2);
    take(2, B, 1);
    take(3, A, 1);
    assertThat(untold()).isZero();
    assertThat(monitors.report().checks("race.told")).isPositive();
  }

  @Test
  void aWinnerThatNobodyKnowsAnyMoreNeedNotBeKnown() {
    take(1, A, 1);
    take(2, B, 2);
    monitors.observe(new Fault(3 * Time.NS_PER_S, A, Fault.CRASH, ""));
    monitors.observe(new Fault(4 * Time.NS_PER_S, A, Fault.RESTART, ""));
    take(5, A, 2);
    assertThat(untold()).isZero();
  }
}

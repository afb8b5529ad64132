package org.starl.apps.race.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Location.Known;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/** What robots tell each other of points and ways, without driving. */
class RaceRulesTest {

  private static final List<RacePoint> POINTS =
      List.of(
          new RacePoint("A", new Point(1_000, 1_000), 100),
          new RacePoint("B", new Point(2_000, 1_000), 100));

  private interface Part {
    void play(Robot robot, List<Object> seen);
  }

  private static final class Robot extends LogicThread {
    private final Part part;
    private final List<Object> seen;

    Robot(GlobalVarHolder gvh, Part part, List<Object> seen) {
      super(gvh);
      this.part = part;
      this.seen = seen;
    }

    @Override
    public List<Object> callStarL() {
      part.play(this, seen);
      return List.of();
    }

    GlobalVarHolder gvh() {
      return gvh;
    }

    void pause(long ms) {
      sleep(ms);
    }

    boolean is(int number) {
      return gvh.id.name().equals(gvh.id.participants().asList().get(number));
    }
  }

  /** What three robots tell that play one part. */
  private static List<Object> played(Part part) {
    List<Object> seen = new ArrayList<>();
    Simulation.builder().seed(1).robots(3, gvh -> new Robot(gvh, part, seen)).build().run();
    return seen;
  }

  @Test
  void aRobotThatKnowsABetterClaimDoesNotTakeTheOthersForInformed() {
    List<Object> seen =
        played((robot, told) -> {
          Scoreboard board = new Scoreboard(robot.gvh(), "race", POINTS);
          if (robot.is(0)) {
            board.claim(0, 50);
          }
          robot.pause(20_000);
          if (robot.is(1)) {
            told.add(board.winners());
            board.claim(0, 0);
            told.add(board.unconfirmed());
          }
          robot.pause(20_000);
          told.add(board.winners());
          told.add(board.unconfirmed());
        });
    List<RobotId> all = List.of(new RobotId("bot0"), new RobotId("bot1"), new RobotId("bot2"));
    assertThat(seen.get(0)).isEqualTo(all.subList(0, 1));
    assertThat(seen.get(1).toString()).isEqualTo("[bot0, bot2]");
    assertThat(seen.subList(2, 8)).hasToString("[[bot1], [], [bot1], [], [bot1], []]");
  }

  @Test
  void aMotionThatBringsARobotNearerIsNotInVain() {
    Patience patience = new Patience(POINTS.get(0), 165); // 430 mm after three in vain
    assertThat(patience.recordFailedMotion(500)).isFalse();
    assertThat(patience.recordFailedMotion(500)).isFalse();
    assertThat(patience.recordFailedMotion(420)).as("the first at this place").isFalse();
    assertThat(patience.recordFailedMotion(420)).isFalse();
    assertThat(patience.recordFailedMotion(420)).isTrue();
  }

  @Test
  void aRobotIsAtAPointOnlyWithACertainPosition() {
    List<Object> seen =
        played((robot, told) -> {
          Drive drive = new Drive(robot.gvh());
          double mostMm = robot.gvh().plat.moat.parameters().maxErrorMm();
          for (double errorMm : new double[] {mostMm, mostMm + 1}) {
            Known known = new Known(new Pose(1_000, 1_000, 0), errorMm, 0, 0, 0);
            told.add(drive.isAt(POINTS.get(0), known));
          }
        });
    assertThat(seen).containsExactly(true, false, true, false, true, false);
  }

  @Test
  void theWayToOnePointIsNotTheWayToAnother() {
    List<Object> seen =
        played((robot, told) -> {
          RightOfWay way = new RightOfWay(robot.gvh(), "race");
          robot.pause(1_000);
          if (robot.is(0)) {
            way.ask(1, robot.gvh().gps.pose().at(), 500);
            told.add(way.isOthers(1));
            robot.pause(100);
            told.add(way.mayAsk(1, 500));
          }
          robot.pause(500);
          told.add(List.of(way.isOthers(0), way.isOthers(1)));
        });
    assertThat(seen.subList(0, 2)).containsExactly(false, false);
    assertThat(seen).contains(List.of(false, true)).doesNotContain(List.of(true, true));
  }

  @Test
  void theWayToAPointIsFreeHoweverNearARobotIsThatHasAnothersWay() {
    List<Object> seen =
        played((robot, told) -> {
          RightOfWay way = new RightOfWay(robot.gvh(), "race");
          robot.pause(1_000);
          if (robot.is(0)) {
            way.ask(0, robot.gvh().gps.pose().at(), 300);
          }
          robot.pause(1_000);
          if (robot.is(1)) {
            way.ask(1, robot.gvh().gps.pose().at(), 900);
          }
          robot.pause(1_000);
          told.add(way.isOthers(1));
        });
    assertThat(seen).containsExactlyInAnyOrder(true, false, true);
  }

  /** The way to its last point takes longer than a minute: that is no time in which it tells. */
  @Test
  void aRobotTellsRobotsThatAreSilentForAllItsPatienceHoweverLongItHasRaced() {
    List<Object> seen =
        played((robot, told) -> {
          if (robot.is(0)) {
            robot.pause(1_000);
            GlobalVarHolder gvh = robot.gvh();
            Point here = gvh.gps.pose().at();
            Point far = new Point(here.xMm(), here.yMm() - 14_000);
            new RaceApp(gvh, "race", List.of(new RacePoint("far", far, 100))).callStarL();
            told.add(gvh.gps.pose().distanceMm(far) < 200);
            told.add(gvh.plat.clock.nowNs() > (70_000 + RaceApp.TELL_PATIENCE_MS) * Time.NS_PER_MS);
          }
        });
    assertThat(seen).containsExactly(true, true);
  }
}

package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** The parts of one searcher, which is alone in {@link TwoRooms}. */
class SearcherTest {

  private interface Part {
    void play(Robot robot);
  }

  private static final class Robot extends LogicThread {
    private final Part part;

    Robot(GlobalVarHolder gvh, Part part) {
      super(gvh);
      this.part = part;
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      part.play(this);
      return List.of();
    }

    GlobalVarHolder gvh() {
      return gvh;
    }

    void pause(long ms) {
      sleep(ms);
    }

    /** Lets it set out, and stops it on the way. */
    void stopOnTheWay() {
      await(gvh.plat.moat::inMotion);
      gvh.plat.moat.motion_stop();
      sleep(200);
    }
  }

  private static void alone(Part part) {
    Simulation.builder()
        .seed(1)
        .settings(SimSettings.builder().set("duration", "400s").build())
        .robot(
            new RobotSpec(
                new RobotId("bot0"),
                new Pose(TwoRooms.HALL.xMm(), TwoRooms.HALL.yMm(), 0),
                true,
                gvh -> new Robot(gvh, part)))
        .build()
        .run();
  }

  @Test
  void eachDriveMayBeginAgainThreeTimes() {
    List<Object> states = new ArrayList<>();
    alone(robot -> {
      Drive drive = new Drive(robot.gvh(), "search", TwoRooms.HOUSE.bounds());
      for (Point to : List.of(new Point(3_000, 1_500), new Point(5_000, 1_500))) {
        drive.to(to, 60_000);
        for (int stops = 0; stops < 3; stops++) {
          robot.stopOnTheWay();
          states.add(drive.check());
        }
      }
    });
    assertThat(states).hasSize(6).containsOnly(Drive.State.UNDER_WAY);
  }

  @Test
  void aRoomThatFailsAgainAndAgainIsGivenUp() {
    List<Object> answers = new ArrayList<>();
    alone(robot -> {
      Team team = new Team(robot.gvh(), "search", TwoRooms.HOUSE);
      team.begin();
      while (!team.hasAnswer()) {
        team.work();
        Optional<Room> room = team.takeTask();
        robot.pause(500);
        room.ifPresent(taken -> team.failedRoom());
      }
      answers.add(team.known().answer().orElseThrow());
    });
    assertThat(answers).containsExactly(new Answer.GaveUp(List.of("A", "B")));
  }
}

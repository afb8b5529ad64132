package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
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

  /** The numbers of a new leader's tasks begin anew. */
  @Test
  void aTaskIsTakenOnceAndOfALaterTermWhateverItsNumber() {
    List<Object> taken = new ArrayList<>();
    alone(robot -> {
      Team team = new Team(robot.gvh(), "search", TwoRooms.HOUSE);
      RobotId self = robot.gvh().id.name();
      for (long[] task : new long[][] {{1, 7}, {1, 7}, {1, 8}, {2, 1}, {2, 1}}) {
        Report.Task first = new Report.Task(0, (int) task[1]);
        Report.Duty duty = new Report.Duty(task[0], new TreeMap<>(Map.of(self, first)));
        team.known()
            .hear(
                new Report(
                    ProcessId.first(new RobotId("bot1"), 1),
                    taken.size() + 1L,
                    Optional.empty(),
                    Report.NO_ROOM,
                    List.of(),
                    new TreeSet<>(),
                    List.of(0, 0),
                    Optional.of(duty),
                    Optional.empty()));
        taken.add(team.takeTask().isPresent());
      }
    });
    assertThat(taken).containsExactly(true, false, true, true, false);
  }

  @Test
  void aRobotThatStandsSeesMoreWhenItKnowsItsPlaceBetter() {
    Room room = TwoRooms.HOUSE.rooms().get(0);
    Coverage coverage = new Coverage(TwoRooms.HOUSE, room.cells());
    List<Integer> unseen = new ArrayList<>();
    for (double errorMm : List.of(400.0, 500.0, 5.0)) {
      coverage.look(room.rest(), errorMm);
      unseen.add(coverage.unseen().cardinality());
    }
    assertThat(unseen.get(1)).isEqualTo(unseen.get(0));
    assertThat(unseen.get(2)).isLessThan(unseen.get(1));
  }
}

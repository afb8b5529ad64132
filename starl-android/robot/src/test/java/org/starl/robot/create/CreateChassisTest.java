package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.robot.create.CreateBody.Battery;
import org.starl.robot.create.CreateBody.Senses;

/** The driver on its own threads, against a simulated robot at the end of real lines. */
class CreateChassisTest {

  @ParameterizedTest
  @EnumSource
  void aBumpStopsTheWheelsAndIsReportedOnTheStrand(Line line) {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, line)) {
      robot.awaitHolds();
      robot.wanted = new WheelCommand(200, 0);
      robot.await("drives", () -> robot.body.leftMmPerS == 200 && robot.body.rightMmPerS == 200);

      robot.body.senses = Senses.bumps(true, true);
      robot.await("heard", () -> robot.heard.contains(Bumps.BOTH));
      robot.await("stands", robot.body::stands);
      robot.awaitHolds(CreateHold.BUMP);

      robot.body.senses = Senses.NOTHING;
      robot.await("drives on", () -> robot.body.leftMmPerS == 200);
      robot.await("told", () -> robot.heard.size() == 2); // the wheels do not wait for this
      assertThat(robot.heard).containsExactly(Bumps.BOTH, Bumps.NONE);
      assertThat(robot.troubles).noneMatch(told -> told.startsWith("no link"));
    }
  }

  @ParameterizedTest
  @EnumSource
  void aBlockedStrandDoesNotDelayTheBumpStop(Line line) {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, line)) {
      robot.wanted = new WheelCommand(200, 0);
      robot.await("drives", () -> robot.body.leftMmPerS == 200);
      CountDownLatch release = new CountDownLatch(1);
      robot.ground.strand().post(() -> await(release));

      robot.body.senses = Senses.bumps(false, true);
      robot.await("stands", robot.body::stands);
      robot.body.senses = Senses.NOTHING;
      robot.await(
          "nothing is felt",
          () ->
              robot.chassis.status().sensors().bumps() == Bumps.NONE
                  && robot.chassis.status().holds().contains(CreateHold.BUMP_UNTOLD));
      assertThat(robot.body.stands()).isTrue();
      assertThat(robot.heard).isEmpty();
      release.countDown();
      robot.await("heard", () -> robot.heard.size() == 2);
      assertThat(robot.heard).containsExactly(Bumps.RIGHT, Bumps.NONE);
    }
  }

  @Test
  void aBlockedStrandStopsTheWheels() {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, Line.MEMORY)) {
      robot.wanted = new WheelCommand(200, 0);
      robot.await("drives", () -> robot.body.leftMmPerS == 200);
      CountDownLatch release = new CountDownLatch(1);
      robot.ground.strand().post(() -> await(release));
      robot.await("stands", robot.body::stands);
      assertThat(robot.chassis.status().holds()).startsWith(CreateHold.STALE_COMMAND);
      robot.await("told", () -> robot.troubles.contains("no command for 300 ms: wheels stopped"));
      release.countDown();
      robot.await("drives on", () -> robot.body.leftMmPerS == 200);
    }
  }

  @Test
  void aBrokenLinkIsReportedAndReopened() {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_1, Line.SOCKET)) {
      robot.wanted = new WheelCommand(200, 0);
      robot.await("drives", () -> robot.body.leftMmPerS == 200);
      MemoryLink[] ends = MemoryLink.pair();
      robot.host.serve(ends[1]);
      robot.await("told", () -> robot.troubles.stream().anyMatch(t -> t.startsWith("no link")));
      robot.await("lost", () -> robot.chassis.status().linksLost() == 1);
      robot.await(
          "drives again",
          () ->
              robot.chassis.status().starts() == 2
                  && robot.chassis.status().mayDrive()
                  && robot.body.leftMmPerS == 200);
    }
  }

  @Test
  void aLinkThatWorkedIsReopenedAtOnce() {
    long hourMs = 3_600_000;
    CreateSettings slow =
        new CreateSettings(
            CreateModel.CREATE_2, OiMode.SAFE, 300, 500, 100, 500, 3000, 200, hourMs, 500);
    try (LiveRobot robot = new LiveRobot(slow, Line.SOCKET)) {
      robot.wanted = new WheelCommand(200, 0);
      robot.await("drives", () -> robot.body.leftMmPerS == 200);
      robot.host.serve(MemoryLink.pair()[1]);
      robot.await("started again", () -> robot.chassis.status().starts() == 2);
    }
  }

  @Test
  void aFailureToConnectIsReportedOnceAndRetried() {
    ByteLink.Source[] later = new ByteLink.Source[1];
    CountDownLatch refused = new CountDownLatch(2);
    try (LiveRobot robot =
        new LiveRobot(
            CreateModel.CREATE_2,
            host -> {
              later[0] = Line.MEMORY.join(host);
              return () -> {
                if (refused.getCount() > 0) {
                  refused.countDown();
                  throw new IOException("no such port");
                }
                return later[0].open();
              };
            })) {
      robot.await("refused twice", () -> refused.getCount() == 0);
      robot.awaitHolds();
      assertThat(robot.troubles)
          .filteredOn(line -> line.startsWith("no link"))
          .containsExactly("no link to the robot: no such port");
      assertThat(robot.chassis.status().linksLost()).isZero();
    }
  }

  @Test
  void anEmergencyStopHoldsTheWheelsUntilItIsReleased() {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, Line.MEMORY)) {
      robot.wanted = new WheelCommand(200, 0);
      robot.await("drives", () -> robot.body.leftMmPerS == 200);
      robot.chassis.emergencyStop();
      robot.await("stands", robot.body::stands);
      robot.awaitHolds(CreateHold.EMERGENCY_STOP);
      robot.chassis.release();
      robot.await("drives on", () -> robot.body.leftMmPerS == 200);
    }
  }

  @Test
  void theProgramIsToldWhatHoldsTheWheelsNowAndAtEachChange() {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, Line.MEMORY)) {
      robot.chassis.emergencyStop();
      robot.awaitHolds(CreateHold.EMERGENCY_STOP);
      List<List<CreateHold>> told = new CopyOnWriteArrayList<>();
      robot.ground.strand().post(() -> robot.chassis.onHolds(told::add));
      robot.await("told", () -> told.contains(List.of(CreateHold.EMERGENCY_STOP)));
      robot.chassis.release();
      robot.await("told of the end", () -> told.getLast().isEmpty());
    }
  }

  @ParameterizedTest
  @EnumSource
  void closingStopsTheRobotAndLeavesItPassive(Line line) {
    LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, line);
    robot.wanted = new WheelCommand(200, 0);
    robot.await("drives", () -> robot.body.leftMmPerS == 200);
    robot.chassis.close();
    robot.await("stands", robot.body::stands);
    robot.host.inspect(create -> assertThat(create.mode()).isEqualTo(OiMode.PASSIVE));
    robot.close();
  }

  @Test
  void aLowBatteryIsToldOnceForEachLevel() {
    try (LiveRobot robot = new LiveRobot(CreateModel.CREATE_2, Line.MEMORY)) {
      for (int charge = 2600; charge >= 0; charge -= 20) {
        robot.body.senses =
            new Senses(Senses.NOTHING.active(), new Battery(12_000, -300, 25, charge, 2600));
      }
      robot.await("told", () -> robot.troubles.contains("battery almost empty: 0 of 2600 mAh"));
      long frames = robot.chassis.status().frames();
      robot.await("more frames", () -> robot.chassis.status().frames() > frames + 20);
      assertThat(robot.troubles)
          .filteredOn(line -> line.startsWith("battery almost"))
          .containsExactly("battery almost empty: 0 of 2600 mAh");
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    }
  }
}

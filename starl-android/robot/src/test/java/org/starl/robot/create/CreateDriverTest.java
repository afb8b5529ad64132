package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.robot.create.CreateBody.Sense;
import org.starl.robot.create.CreateBody.Senses;

/** What the driver promises, held by the simulated robot over a line of its true speed. */
class CreateDriverTest {

  @ParameterizedTest
  @EnumSource
  void theDriveCommandNamesTheRightWheelFirst(CreateModel model) {
    Bench bench = Bench.ready(model);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.SAFE);
    assertThat(bench.driver.status().holds()).isEmpty();

    bench.wanted = new WheelCommand(100, 0.5);
    bench.runMs(100);

    double half = 0.25 * model.axleMm();
    assertThat(bench.body.leftMmPerS).isCloseTo(100 - half, within(0.5));
    assertThat(bench.body.rightMmPerS).isCloseTo(100 + half, within(0.5));
    assertThat(bench.driver.status().droppedBytes()).isLessThan(StreamDecoder.TO_LEARN * 64L);
    assertThat(bench.robot.refused()).as("the stop that precedes the start").isEqualTo(1);
  }

  @ParameterizedTest
  @EnumSource
  void limitedSpeedsKeepTheCurvature(CreateModel model) {
    Bench bench = Bench.ready(model);
    bench.wanted = new WheelCommand(800, 2);
    bench.runMs(100);
    double ratio =
        bench.wanted.leftMmPerS(model.axleMm()) / bench.wanted.rightMmPerS(model.axleMm());
    assertThat(bench.body.rightMmPerS).isEqualTo(500);
    assertThat(bench.body.leftMmPerS / bench.body.rightMmPerS).isCloseTo(ratio, within(0.01));
  }

  @ParameterizedTest
  @EnumSource
  void thePowerButtonShowsTheProgramsColourFromGreenToRed(CreateModel model) {
    Bench bench = Bench.ready(model);
    bench.driver.light(0xFF0000);
    bench.runMs(50);
    assertThat(bench.robot.lights()).containsExactly(0, 255, 255);
    bench.driver.light(0x008000);
    bench.runMs(50);
    assertThat(bench.robot.lights()).containsExactly(0, 0, 128);
    bench.driver.light(0x0000FF);
    bench.runMs(50);
    assertThat(bench.robot.lights()).as("blue: green, as bright").containsExactly(0, 0, 255);
    bench.driver.light(0x404000);
    bench.runMs(50);
    assertThat(bench.robot.lights()).containsExactly(0, 127, 64);
    bench.driver.light(0);
    bench.runMs(50);
    assertThat(bench.robot.lights()).containsExactly(0, 0, 0);
  }

  @Test
  void theLightReturnsWhenTheRobotWasRestartedAndGoesOutAtTheEnd() {
    Bench bench = Bench.ready(CreateModel.CREATE_2);
    bench.driver.light(0xFFFFFF);
    bench.runMs(50);
    bench.body.senses = Senses.lifted();
    bench.runMs(100);
    bench.body.senses = Senses.NOTHING;
    bench.runMs(1700);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.SAFE);
    assertThat(bench.robot.lights()).as("entering a mode clears it").containsExactly(0, 127, 255);

    bench.driver.end(bench.nowNs);
    bench.runMs(100);
    assertThat(bench.robot.lights()).containsExactly(0, 0, 0);
  }

  @Test
  void aProgramWithoutALightLeavesTheLightsToTheRobot() {
    Bench bench = Bench.ready(CreateModel.CREATE_2);
    byte[] command = {(byte) Opcodes.LEDS, 0, 1, 2};
    bench.robot.receive(command, command.length, bench.nowNs);
    bench.runMs(2000);
    assertThat(bench.robot.lights()).containsExactly(0, 1, 2);
  }

  @Test
  void proximitySensorsHaveBearingsFromLeftToRight() {
    Bench second = Bench.ready(CreateModel.CREATE_2);
    second.body.senses = Senses.of(Sense.LIGHT_LEFT, Sense.LIGHT_CENTRE_RIGHT);
    second.runMs(50);
    assertThat(second.driver.status().sensors().nearRad())
        .containsExactly(StrictMath.PI * 5 / 12, -StrictMath.PI / 12);

    Bench first = Bench.ready(CreateModel.CREATE_1);
    first.body.senses = Senses.of(Sense.LIGHT_LEFT, Sense.WALL);
    first.runMs(50);
    assertThat(first.driver.status().sensors().nearRad())
        .as("a Create 1 has no light bumper")
        .containsExactly(-StrictMath.PI * 5 / 12);
  }

  @ParameterizedTest
  @EnumSource
  void aBumpStopsTheWheelsBeforeTheStrandIsInformed(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.isStrandBusy = true;
    bench.body.senses = Senses.bumps(true, false);

    assertThat(bench.msUntilItStands(1000)).isBetween(0.0, 40.0);
    bench.runMs(200);
    assertThat(bench.body.stands()).isTrue();
    assertThat(bench.heard).isEmpty();

    bench.body.senses = Senses.NOTHING;
    bench.runMs(100);
    assertThat(bench.body.stands()).as("a touch that is over, and not heard of").isTrue();
    bench.isStrandBusy = false;
    bench.runMs(100);
    assertThat(bench.heard).containsExactly(Bumps.LEFT, Bumps.NONE);
    assertThat(bench.body.stands()).as("and it goes on as the program says").isFalse();
  }

  @Test
  void aBlockedRobotTurnsAndBacksButDoesNotPush() {
    Bench bench = Bench.driving(CreateModel.CREATE_2);
    bench.body.senses = Senses.bumps(true, true);
    bench.runMs(200);
    assertThat(bench.body.stands()).isTrue();
    assertThat(bench.driver.status().holds()).containsExactly(CreateHold.BUMP);
    bench.wanted = new WheelCommand(100, 1);
    bench.runMs(100);
    assertThat(bench.body.leftMmPerS).isEqualTo(-bench.body.rightMmPerS).isNegative();
    bench.wanted = new WheelCommand(-100, 0);
    bench.runMs(100);
    assertThat(bench.body.leftMmPerS).isEqualTo(-100);
  }

  @ParameterizedTest
  @EnumSource
  void afterACliffTheRobotReturnsToSafeModeAndBacksStraightOut(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.body.senses = Senses.of(Sense.CLIFF_FRONT_LEFT);
    assertThat(bench.msUntilItStands(1000)).isBetween(0.0, 40.0);
    bench.runMs(20);
    assertThat(bench.driver.status().holds())
        .containsExactly(CreateHold.NOT_IN_MODE, CreateHold.CLIFF);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.PASSIVE);

    bench.runMs(800);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.SAFE);
    assertThat(bench.body.stands()).isTrue();
    assertThat(bench.driver.status().recoveries()).isEqualTo(1);

    bench.wanted = new WheelCommand(-80, 1);
    bench.runMs(100);
    assertThat(bench.body.leftMmPerS).isEqualTo(-80);
    assertThat(bench.body.rightMmPerS).isEqualTo(-80);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.SAFE);
  }

  @ParameterizedTest
  @EnumSource
  void inFullModeTheDriverStopsAtACliff(CreateModel model) {
    Bench bench = new Bench(Bench.settings(model, OiMode.FULL, 500));
    bench.driver.linkOpened(0);
    bench.wanted = new WheelCommand(250, 0);
    bench.runMs(600);
    assertThat(bench.body.stands()).isFalse();
    bench.body.senses = Senses.of(Sense.CLIFF_FRONT_LEFT);
    assertThat(bench.msUntilItStands(1000)).isBetween(0.0, 40.0);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.FULL);
  }

  @ParameterizedTest
  @EnumSource
  void aLiftedRobotStopsUntilItHasBeenBackOnTheFloorForAWhile(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.body.senses = Senses.lifted();
    assertThat(bench.msUntilItStands(1000)).isBetween(0.0, 40.0);
    bench.runMs(5000);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.PASSIVE);
    assertThat(bench.driver.status().recoveries()).isZero();

    bench.body.senses = Senses.NOTHING;
    bench.runMs(450);
    assertThat(bench.body.stands()).isTrue();
    bench.runMs(400);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.SAFE);
    assertThat(bench.body.leftMmPerS).isEqualTo(250);
  }

  @Test
  void aHangingProgramStopsTheWheels() {
    Bench bench = Bench.driving(CreateModel.CREATE_2);
    bench.runMs(60);
    bench.isProgramAlive = false;
    assertThat(bench.msUntilItStands(1000)).isBetween(200.0, 330.0);
    assertThat(bench.driver.status().holds()).containsExactly(CreateHold.STALE_COMMAND);
    bench.isProgramAlive = true;
    bench.runMs(100);
    assertThat(bench.body.stands()).isFalse();
  }

  @Test
  void missingFixesStopTheWheelsIfFixesAreUsed() {
    Bench bench = Bench.driving(CreateModel.CREATE_2);
    bench.hasFixes = false;
    assertThat(bench.msUntilItStands(1000)).isBetween(400.0, 530.0);
    assertThat(bench.driver.status().holds()).containsExactly(CreateHold.STALE_POSITION);

    Bench blind = new Bench(Bench.settings(CreateModel.CREATE_2, OiMode.SAFE, 0));
    blind.hasFixes = false;
    blind.driver.linkOpened(0);
    blind.wanted = new WheelCommand(250, 0);
    blind.runMs(1000);
    assertThat(blind.body.stands()).isFalse();
  }

  @ParameterizedTest
  @EnumSource
  void aSilentRobotIsStoppedAndRestarted(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.isRobotHeard = false;
    assertThat(bench.msUntilItStands(1000)).isBetween(80.0, 140.0);
    assertThat(bench.driver.status().holds()).containsExactly(CreateHold.NO_SENSORS);
    bench.runMs(1500);
    assertThat(bench.driver.status().starts()).isGreaterThan(1);
    bench.isRobotHeard = true;
    bench.runMs(1500);
    assertThat(bench.driver.status().holds()).isEmpty();
    assertThat(bench.body.stands()).isFalse();
  }

  @ParameterizedTest
  @EnumSource
  void aRobotSwitchedOffIsRestarted(CreateModel model) {
    Bench bench = Bench.driving(model);
    Bench other = Bench.of(model);
    assertThat(other.robot.mode()).isEqualTo(OiMode.OFF);
    bench.isRobotHearing = false;
    bench.isRobotHeard = false;
    bench.runMs(3100);
    assertThat(bench.driver.isLinkDead(bench.nowNs)).isTrue();
    assertThat(bench.driver.linkLost(bench.nowNs)).as("it was heard").isTrue();
    assertThat(bench.driver.linkLost(bench.nowNs)).as("there was no link").isFalse();
    assertThat(bench.driver.status().holds()).contains(CreateHold.NO_LINK);
    bench.isRobotHearing = true;
    bench.isRobotHeard = true;
    bench.driver.linkOpened(bench.nowNs);
    bench.runMs(500);
    assertThat(bench.driver.status().holds()).isEmpty();
    assertThat(bench.driver.status().linksLost()).isEqualTo(1);
  }

  @ParameterizedTest
  @EnumSource
  void anEmergencyStopHoldsUntilItsRelease(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.driver.emergencyStop(true);
    assertThat(bench.msUntilItStands(1000)).isBetween(0.0, 15.0);
    bench.runMs(1000);
    assertThat(bench.body.stands()).isTrue();
    bench.driver.emergencyStop(false);
    bench.runMs(200);
    assertThat(bench.body.stands()).isFalse();
  }

  @ParameterizedTest
  @EnumSource
  void aCommandCutOffByABrokenLinkEndsInAStop(CreateModel model) {
    Bench bench = Bench.of(model);
    byte[] cutOff = {(byte) 128, (byte) 132, (byte) 145, 1};
    bench.robot.receive(cutOff, cutOff.length, 0);
    bench.driver.linkOpened(0);
    bench.runMs(400);
    assertThat(bench.driver.status().holds()).isEmpty();
    assertThat(bench.body.driven)
        .as("the high byte that had come, then zeros, for some bytes' time")
        .isEqualTo(List.of("0,256", "0,0"));
  }

  @ParameterizedTest
  @EnumSource
  void doubtedFixesStopTheWheelsUntilTheNextFix(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.hasFixes = false;
    bench.driver.doubted(bench.nowNs);
    bench.driver.fixed(bench.nowNs - 1, bench.nowNs);
    assertThat(bench.msUntilItStands(300)).isBetween(0.0, 30.0);
    bench.hasFixes = true;
    bench.runMs(300);
    assertThat(bench.driver.status().holds()).isEmpty();
  }

  @Test
  void odometryIsGivenWithEachFrameAndMarksContacts() {
    Bench bench = Bench.ready(CreateModel.CREATE_2);
    List<CreateTravel> travels = new ArrayList<>();
    List<Boolean> touched = new ArrayList<>();
    List<Boolean> lifted = new ArrayList<>();
    bench.driver.onTravel(
        new Wheelbase.TravelReceiver() {
          @Override
          public void travelled(long atNs, CreateTravel travel, double mmPerS, boolean isTouched) {
            travels.add(travel);
            touched.add(isTouched);
          }

          @Override
          public void lifted(boolean isLifted) {
            lifted.add(isLifted);
          }

          @Override
          public void lost() {
            travels.clear();
          }
        });
    bench.wanted = new WheelCommand(250, 0);
    bench.runMs(2000);
    assertThat(travels.getLast().forwardMm() - travels.getFirst().forwardMm())
        .isCloseTo(490, within(20.0));
    assertThat(touched).doesNotContain(true);
    assertThat(lifted).doesNotContain(true);
    bench.body.senses = Senses.bumps(true, false);
    bench.runMs(100);
    assertThat(touched).contains(true);
    assertThat(lifted).doesNotContain(true);
    touched.clear();
    bench.body.senses = Senses.lifted();
    bench.runMs(100);
    assertThat(lifted).endsWith(true);
    assertThat(touched).endsWith(false);
    bench.body.senses = Senses.NOTHING;
    bench.runMs(100);
    assertThat(lifted).endsWith(false);
    bench.driver.linkLost(bench.nowNs);
    bench.driver.linkOpened(bench.nowNs);
    assertThat(travels).isEmpty();
  }

  @Test
  void odometryHandlesEncoderWraparound() {
    Bench bench = Bench.driving(CreateModel.CREATE_2);
    double from = bench.driver.status().sensors().travel().forwardMm();
    bench.wanted = new WheelCommand(400, 0);
    // 65536 counts are 29135 mm.
    bench.runMs(100_000);
    double way = bench.driver.status().sensors().travel().forwardMm() - from;
    assertThat(way).isCloseTo(40_000, within(50.0));
    bench.wanted = new WheelCommand(0, 1);
    bench.runMs(60);
    double heading = bench.driver.status().sensors().travel().turnedRad();
    bench.runMs(3000);
    assertThat(bench.driver.status().sensors().travel().turnedRad() - heading)
        .isCloseTo(3, within(0.05));
  }

  @Test
  void aCreate1ReportsDistanceAndAngle() {
    Bench bench = Bench.driving(CreateModel.CREATE_1);
    double from = bench.driver.status().sensors().travel().forwardMm();
    bench.runMs(10_000);
    assertThat(bench.driver.status().sensors().travel().forwardMm() - from)
        .isCloseTo(2500, within(10.0));
  }

  @Test
  void checksumsWithoutTheHeaderAreAcceptedFromACreate1() {
    Bench bench = Bench.of(CreateModel.CREATE_1);
    bench.robot.withoutHeaderInChecksums();
    bench.driver.linkOpened(0);
    bench.runMs(400);
    assertThat(bench.driver.status().holds()).isEmpty();
    assertThat(bench.driver.status().badFrames()).isZero();
  }

  @ParameterizedTest
  @EnumSource
  void closingRepeatsTheStopUntilTheRobotConfirmsIt(CreateModel model) {
    Bench bench = Bench.driving(model);
    bench.driver.end(bench.nowNs);
    assertThat(bench.driver.hasEnded()).isFalse();
    bench.isRobotHearing = false;
    bench.runMs(100);
    assertThat(bench.body.stands()).as("it heard nothing of it").isFalse();
    assertThat(bench.driver.hasEnded()).isFalse();
    bench.isRobotHearing = true;
    bench.runMs(100);
    assertThat(bench.robot.mode()).isEqualTo(OiMode.PASSIVE);
    assertThat(bench.body.stands()).isTrue();
    assertThat(bench.driver.hasEnded()).isTrue();
  }

  @Test
  void aLinkWhoseFramesStopIsDeadAfterItsTimeoutAndANewOneMayTakeLonger() {
    CreateSettings settings =
        CreateSettings.of(CreateModel.CREATE_2).withLimits(300, 500, 500, 200, 500);
    Bench bench = new Bench(settings);
    bench.isRobotHeard = false;
    bench.driver.linkOpened(0);
    bench.runMs(CreateSettings.OPEN_MS - 50);
    assertThat(bench.driver.isLinkDead(bench.nowNs)).isFalse();
    bench.isRobotHeard = true;
    bench.runMs(1000);
    assertThat(bench.driver.isLinkDead(bench.nowNs)).isFalse();

    bench.isRobotHeard = false;
    bench.runMs(450);
    assertThat(bench.driver.isLinkDead(bench.nowNs)).isFalse();
    bench.runMs(100);
    assertThat(bench.driver.isLinkDead(bench.nowNs)).isTrue();
  }
}

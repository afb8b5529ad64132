package org.starl.robot.create;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.robot.create.CreateBody.Sense;
import org.starl.robot.create.CreateBody.Senses;

/** The simulated robot by itself: what it answers, how it drives, what takes it out of safe mode. */
class SimulatedCreateTest {

  private static final long MS = 1_000_000;

  private final FloorBody body = new FloorBody();
  private final List<byte[]> said = new ArrayList<>();
  private SimulatedCreate robot = robot(CreateModel.CREATE_2);
  private long nowNs;

  private SimulatedCreate robot(CreateModel model) {
    return new SimulatedCreate(model, body, said::add);
  }

  private void tell(int... bytes) {
    byte[] line = new byte[bytes.length];
    for (int i = 0; i < bytes.length; i++) {
      line[i] = (byte) bytes[i];
    }
    robot.receive(line, line.length, nowNs);
  }

  private void runMs(long ms) {
    for (long end = nowNs + ms * MS; nowNs < end; nowNs += MS) {
      robot.advance(nowNs);
    }
  }

  private byte[] answer() {
    return said.get(said.size() - 1);
  }

  @Test
  void groupsHaveTheSizesOfTheSpecifications() {
    int[][] sizes = {
      {0, 26}, {1, 10}, {2, 6}, {3, 10}, {4, 14}, {5, 12}, {6, 52}, {100, 80}, {101, 28}, {106, 12},
      {107, 9}
    };
    for (int[] size : sizes) {
      assertThat(Packets.bytesOfAll(size[0])).as("group " + size[0]).isEqualTo(size[1]);
    }
    assertThat(Packets.bytes(32)).as("cargo bay, digital").isEqualTo(1);
    assertThat(Packets.bytes(33)).as("cargo bay, analog").isEqualTo(2);
    assertThat(Packets.first(CreateModel.CREATE_1, 43)).isEqualTo(-1);
    assertThat(Packets.first(CreateModel.CREATE_1, 100)).isEqualTo(-1);
    assertThat(Packets.first(CreateModel.CREATE_2, 59)).isEqualTo(-1);
  }

  @Test
  void everySpecifiedQueryIsAnswered() {
    tell(128, 132, 145, 0, 200, 0xFF, 156);
    runMs(100);
    tell(142, 100);
    byte[] all = answer();
    assertThat(all).hasSize(80);
    assertThat(all[40]).as("mode").isEqualTo((byte) 3);
    assertThat(all[49] & 0xFF).as("right speed, low byte").isEqualTo(200);
    assertThat(all[51] & 0xFF).as("left speed, low byte").isEqualTo(156);
    assertThat((all[17] & 0xFF) << 8 | (all[18] & 0xFF)).as("mV").isEqualTo(16_000);
    tell(149, 2, 35, 26);
    assertThat(answer()).containsExactly(3, 10, 40);
  }

  @Test
  void lightsAndSongsAreObeyed() {
    tell(128, 132, 139, 4, 255, 128);
    tell(140, 3, 2, 69, 32, 72, 32, 141, 3);
    assertThat(robot.lights()).containsExactly(4, 255, 128);
    assertThat(robot.playing()).isEqualTo(3);
    runMs(1100);
    assertThat(robot.playing()).isEqualTo(-1);
  }

  @Test
  void aRobotThatIsOffReactsOnlyToStart() {
    tell(131, 132, 142, 35);
    assertThat(said).isEmpty();
    assertThat(robot.mode()).isEqualTo(OiMode.OFF);
    tell(128, 145, 0, 100, 0, 100);
    assertThat(robot.mode()).isEqualTo(OiMode.PASSIVE);
    assertThat(body.stands()).isTrue();
  }

  @Test
  void theRobotDrivesCurvesStraightLinesAndTurnsOnTheSpot() {
    tell(128, 132, 137, 0, 200, 0x80, 0);
    assertThat(body.driven).endsWith("200,200");
    tell(137, 0, 200, 0, 1);
    assertThat(body.driven).endsWith("-200,200");
    tell(137, 0, 200, 0xFF, 0xFF);
    assertThat(body.driven).endsWith("200,-200");
    // 500 mm to the left: the wheels are 235 mm apart.
    tell(137, 0, 200, 500 >> 8, 500 & 0xFF);
    assertThat(body.driven).endsWith("153,247");
    tell(137, 0x7F, 0xFF, 0x7F, 0xFF);
    assertThat(body.driven).endsWith("500,500");
  }

  @Test
  void theStreamHasAFrameEvery15MsUntilItIsPaused() {
    tell(128, 148, 2, 29, 13);
    runMs(151);
    assertThat(said).hasSize(10);
    assertThat(answer()).containsExactly(19, 5, 29, 0, 0, 13, 0, -66);
    tell(150, 0);
    runMs(100);
    assertThat(said).hasSize(10);
    tell(150, 1);
    runMs(30);
    assertThat(said).hasSize(12);
  }

  @Test
  void aStreamAboveTheLineRateIsRefused() {
    tell(128, 148, 3, 100, 100, 100);
    runMs(100);
    assertThat(said).isEmpty();
    assertThat(robot.refused()).isEqualTo(1);
  }

  @Test
  void dangersEndSafeMode() {
    for (Senses danger :
        List.of(Senses.lifted(), Senses.of(Sense.CHARGER), Senses.of(Sense.CLIFF_FRONT_LEFT))) {
      body.senses = Senses.NOTHING;
      runMs(20);
      tell(128, 131, 145, 0, 100, 0, 100);
      body.senses = danger;
      runMs(20);
      assertThat(robot.mode()).isEqualTo(OiMode.PASSIVE);
      assertThat(body.stands()).isTrue();
    }
    tell(131, 145, 0xFF, 156, 0xFF, 156);
    runMs(20);
    assertThat(robot.mode()).as("straight back from a cliff").isEqualTo(OiMode.SAFE);
    tell(145, 0xFF, 156, 0, 0);
    runMs(20);
    assertThat(robot.mode()).as("round a wheel at a cliff").isEqualTo(OiMode.PASSIVE);
    tell(132, 145, 0, 100, 0, 100);
    runMs(20);
    assertThat(robot.mode()).as("full mode minds nothing").isEqualTo(OiMode.FULL);
  }

  @Test
  void aRobotWithoutNewCommandsContinuesToDrive() {
    tell(128, 131, 145, 0, 100, 0, 100);
    runMs(60_000);
    assertThat(body.leftMmPerS).isEqualTo(100);
  }

  @Test
  void commandsDependOnTheModel() {
    robot = robot(CreateModel.CREATE_1);
    tell(128, 132, 173, 146);
    assertThat(robot.unknownBytes()).isEqualTo(2);
    assertThat(robot.mode()).isEqualTo(OiMode.FULL);
    tell(152, 3, 137, 0, 0, 136, 7);
    assertThat(robot.mode()).as("a demonstration").isEqualTo(OiMode.PASSIVE);
  }
}

package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.geometry.Pose;

/** Lines that are taken, lines that are refused, and what is made of their times. */
class JsonFeedTest {

  private static final long MS = 1_000_000;
  private static final String LINE =
      "{\"robot\":\"bot0\",\"xMm\":1200,\"yMm\":-350.5,\"headingRad\":1.5,\"errorMm\":4,"
          + "\"atNs\":81234000000}";

  private final List<String> lines = new ArrayList<>();
  private final Tally tally = new Tally((timeNs, level, tag, line) -> lines.add(line), "test");
  private final JsonProtocol protocol = new JsonProtocol(FixBounds.DEFAULT, null, tally);

  private static JsonPoseParser.Result parse(String line) {
    byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
    return JsonPoseParser.parse(bytes, bytes.length);
  }

  private TrackedBody receive(String robot, long atNs, long nowNs) {
    String line = LINE.replace("bot0", robot).replace("81234000000", String.valueOf(atNs));
    byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
    return protocol.received(bytes, bytes.length, nowNs);
  }

  @Test
  void aLineIsAPose() {
    assertThat(parse(LINE).pose())
        .isEqualTo(new JsonPose("bot0", new Pose(1200, -350.5, 1.5), 4, 0, 81_234_000_000L));
  }

  @Test
  void aNameMayContainEscapes() {
    assertThat(parse(LINE.replace("bot0", "\\u0062ot0")).pose()).isEqualTo(parse(LINE).pose());
  }

  @Test
  void keysMayHaveAnyOrderAndSpacing() {
    String line =
        " { \"errorRad\" : 1e-2 ,\"atNs\":-5,\t\"yMm\":0, \"xMm\":-0.0,\r\n\"errorMm\":2.5E+1,"
            + "\"headingRad\":-3.5,\"robot\":\"Bot_1.x\" } \n";
    JsonPose pose = parse(line).pose();
    assertThat(pose).isNotNull();
    assertThat(pose.robot()).isEqualTo("Bot_1.x");
    assertThat(pose.errorMm()).isEqualTo(25);
    assertThat(pose.errorRad()).isEqualTo(0.01);
    assertThat(pose.atNs()).isEqualTo(-5);
    assertThat(pose.pose().headingRad()).isCloseTo(2 * StrictMath.PI - 3.5, within(1e-12));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "{",
        "{}",
        "null",
        "[]",
        "{\"robot\"",
        "{\"robot",
        "{\"robot\":",
        "{\"robot\":\"",
        "{\"robot\":\"bot0\"}",
        "{\"robot\":\"bot0\",}",
        "{,}"
      })
  void linesThatAreNotPosesAreRefused(String line) {
    assertThat(parse(line).pose()).isNull();
    assertThat(parse(line).problem()).isNotEmpty().doesNotContain("\n");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "1200->01200",
        "1200->+1200",
        "1200->1.",
        "1200->.5",
        "1200->1e",
        "1200->1e999",
        "1200->NaN",
        "1200->Infinity",
        "1200->0x10",
        "1200->1d",
        "1200->\"1200\"",
        "1200->null",
        "1200->-",
        "1200->10000001",
        "1200->11111111111111111111111111111111111111111111",
        ":4,->:-4,",
        "81234000000->1.5",
        "81234000000->1e3",
        "81234000000->9223372036854775808",
        "81234000000->99999999999999999999999999",
        "bot0->0bot",
        "bot0->b t",
        "bot0->bót",
        "bot0->",
        "robot->Robot",
        "yMm->xMm",
        "yMm->zMm",
        "yMm->",
        "}->}x",
        "}->}{}",
        "}->,}",
        "}->",
        "\"xMm\"->xMm",
        "{->{{",
        ":4->=4"
      })
  void oneWrongCharacterIsRefused(String change) {
    String from = change.substring(0, change.indexOf("->"));
    String to = change.substring(change.indexOf("->") + 2);
    assertThat(LINE).contains(from);
    assertThat(parse(LINE.replace(from, to)).pose()).as(change).isNull();
  }

  @Test
  void everyTruncatedLineIsRefused() {
    for (int length = 0; length < LINE.length(); length++) {
      assertThat(parse(LINE.substring(0, length)).pose()).isNull();
    }
    assertThat(parse(LINE + " ".repeat(JsonPoseParser.MAX_BYTES)).problem())
        .contains("at most 1024");
  }

  @Test
  void noTextOfTheParserIsShown() {
    assertThat(parse(LINE.replace("1200", "NaN")).problem())
        .matches("column \\d+: expected a number from -1.0E7 to 1.0E7");
    assertThat(parse(LINE.replace("1200", "1_200")).problem())
        .matches(
            "column \\d+: expected a JSON object, each key once, numbers of at most 40 digits");
  }

  @Test
  void aRefusalIsLoggedOnceWithItsColumnAndThenCounted() {
    String line = LINE.replace("1200", "12o0");
    byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
    assertThat(protocol.received(bytes, bytes.length, 0)).isNull();
    assertThat(protocol.received(bytes, bytes.length, 0)).isNull();
    assertThat(lines).hasSize(1).allMatch(each -> each.contains("column 25: "));
    assertThat(tally.statistics().dropped(FeedDrop.MALFORMED)).isEqualTo(2);
  }

  @Test
  void timesAreConvertedFromTheSendersClock() {
    long offNs = 900_000 * MS;
    TrackedBody body = null;
    for (int i = 0; i <= 60; i++) {
      body = receive("bot0", offNs + 10 * i * MS, 10 * i * MS + 3 * MS);
      assertThat(body == null).isEqualTo(i < 50);
    }
    // Not later than it came, not earlier than the assumed 20 ms before.
    assertThat(body.fix().timeNs()).isBetween(593 * MS - MS / 10, 593 * MS + MS / 10);
    assertThat(body.fix().errorMm()).isBetween(10.0, 10.1);
    assertThat(receive("bot0", offNs + 590 * MS, 610 * MS)).isNull();
    assertThat(receive("bot0", offNs + 610 * MS, 1500 * MS)).isNull();
    assertThat(tally.statistics().dropped(FeedDrop.OUTDATED)).isEqualTo(1);
    assertThat(tally.statistics().dropped(FeedDrop.STALE)).isEqualTo(1);
  }

  @Test
  void tooManyRobotsAreRefused() {
    for (int i = 0; i <= JsonProtocol.MAX_ROBOTS; i++) {
      receive("bot" + i, 0, 0);
    }
    assertThat(tally.statistics().dropped(FeedDrop.TOO_MANY)).isEqualTo(1);
    assertThat(tally.statistics().dropped(FeedDrop.EARLY)).isEqualTo(JsonProtocol.MAX_ROBOTS);
  }

  @ParameterizedTest
  @ValueSource(longs = {-100_000, -2000, -900, 200, 900, 5000, 1_000_000})
  void singleLinesWithAFalseTimeTakeNoFixes(long falseMs) {
    int fixes = 0;
    for (int i = 0; i < 400; i++) {
      if (i % 20 == 19) {
        assertThat(receive("bot0", (10 * i + falseMs) * MS, 10 * i * MS + 3 * MS)).isNull();
      }
      fixes += receive("bot0", 10 * i * MS, 10 * i * MS + 4 * MS) == null ? 0 : 1;
    }
    assertThat(fixes).isGreaterThan(340);
  }

  @Test
  void forgedLinesWithoutAKeyStopTheRobotAndAreTold() {
    FixBounds bounds = FixBounds.DEFAULT.withMotion(550, 700);
    JsonProtocol open = new JsonProtocol(bounds, null, tally);
    List<String> stops = new ArrayList<>();
    tally.own("bot0", new WheelPath(0.1, 200 * MS), () -> stops.add("stop"));
    int fixes = 0;
    for (int ms = 0; ms < 5000; ms++) {
      boolean isForged = ms >= 2000 && ms % 3 == 0;
      if (isForged || ms % 10 == 0) {
        String line = LINE.replace("81234000000", String.valueOf(ms * MS));
        byte[] bytes =
            (isForged ? line.replace("1200", "600") : line).getBytes(StandardCharsets.UTF_8);
        TrackedBody body = open.received(bytes, bytes.length, ms * MS + 2 * MS);
        fixes += body == null || ms < 2030 ? 0 : 1;
      }
    }
    assertThat(fixes).isZero();
    assertThat(stops).isNotEmpty();
    assertThat(lines).anyMatch(line -> line.contains("bot0 is measured at (1200 mm"));
  }
}

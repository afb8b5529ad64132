package org.starl.robot.optitrack;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a line of the JSON feed: a pose that is taken is one, and says the same when told again. */
public class JsonFeedFuzzTest {

  private static final long NOW_NS = 1_000_000_000;

  public static void fuzzerTestOneInput(byte[] input) {
    JsonPoseParser.Result result = JsonPoseParser.parse(input, input.length);
    require((result.pose() == null) != result.problem().isEmpty(), "pose and problem");
    requireLine(result.problem());
    JsonPose pose = result.pose();
    if (pose != null) {
      require(RobotId.isValid(pose.robot()), "no robot");
      require(Math.abs(pose.pose().xMm()) <= 1e7 && Math.abs(pose.pose().yMm()) <= 1e7, "far");
      require(Math.abs(pose.pose().headingRad()) <= StrictMath.PI, "heads nowhere");
      require(pose.errorMm() >= 0 && pose.errorMm() <= 1e7, "error in mm");
      require(pose.errorRad() >= 0 && pose.errorRad() <= 1e3, "error in rad");
      byte[] again = line(pose).getBytes(StandardCharsets.US_ASCII);
      require(pose.equals(JsonPoseParser.parse(again, again.length).pose()), "says something else");
      require(
          JsonPoseParser.parse(input, input.length - 1).pose() == null || isBlank(input), "cut");
    }
    Tally tally = new Tally((timeNs, level, tag, line) -> requireLine(line), "fuzz");
    JsonProtocol feed = new JsonProtocol(FixBounds.DEFAULT, null, tally);
    for (int i = 1; i <= 3; i++) {
      TrackedBody body = feed.received(input, input.length, i * NOW_NS);
      require(body == null || (pose != null && body.fix() != null), "a body of nothing");
      require(body == null || body.fix().timeNs() <= i * NOW_NS, "from the future");
    }
  }

  /** Whether what ends the input is nothing that counts. */
  private static boolean isBlank(byte[] input) {
    return " \t\r\n".indexOf(input[input.length - 1]) >= 0;
  }

  private static String line(JsonPose pose) {
    return "{\"robot\":\""
        + pose.robot()
        + "\",\"xMm\":"
        + pose.pose().xMm()
        + ",\"yMm\":"
        + pose.pose().yMm()
        + ",\"headingRad\":"
        + pose.pose().headingRad()
        + ",\"errorMm\":"
        + pose.errorMm()
        + ",\"errorRad\":"
        + pose.errorRad()
        + ",\"atNs\":"
        + pose.atNs()
        + "}";
  }

  private static void requireLine(String line) {
    require(line.length() < 1000 && line.chars().noneMatch(Character::isISOControl), line);
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  void noLineBreaksTheFeed() {
    String line =
        "{\"robot\":\"bot0\",\"xMm\":12,\"yMm\":-35.5e0,\"headingRad\":1.5,\"errorMm\":4,"
            + "\"errorRad\":0.1,\"atNs\":1000000000}";
    List<byte[]> samples = new ArrayList<>();
    samples.add(line.getBytes(StandardCharsets.US_ASCII));
    samples.add(
        line.replace(",", " ,\t").replace("1.5", "-0.5E-3").getBytes(StandardCharsets.US_ASCII));
    for (String large : List.of(":12,", ":4,", ":0.1,")) {
      samples.add(line.replace(large, ":1e8,").getBytes(StandardCharsets.US_ASCII));
    }
    samples.add(Arrays.copyOf("\"\\u00e9\"0.0e+1 {} []".getBytes(StandardCharsets.US_ASCII), 24));

    MalformedBytes.feed(samples, JsonFeedFuzzTest::fuzzerTestOneInput);
  }
}

package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Robots that start at one time on a computer that has never run one with ROS 2. */
@Tag("realtime")
class RosNodeProcessTest {

  private static final int ROBOTS = 4;

  /** One robot: it joins the network, and ends. */
  static final class Joining {
    public static void main(String[] args) throws IOException {
      RosNode.open("joining", () -> 0, (timeNs, level, tag, line) -> {}).close();
    }
  }

  @TempDir private Path home;

  @Test
  void robotsStartTogetherTheFirstTime() throws IOException, InterruptedException {
    List<Process> robots = new ArrayList<>();
    for (int i = 0; i < ROBOTS; i++) {
      robots.add(
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-XX:ErrorFile=" + home.resolve("error" + i),
                  "-Duser.home=" + home,
                  "-cp",
                  System.getProperty("java.class.path"),
                  Joining.class.getName())
              .redirectErrorStream(true)
              .start());
    }
    for (Process robot : robots) {
      String text = new String(robot.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertThat(robot.waitFor()).as(text).isZero();
    }
  }
}

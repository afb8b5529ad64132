package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.starl.body.WheelCommand;
import org.starl.robot.file.RosTopic;
import org.starl.robot.realtime.RealClock;
import org.starl.time.Time;

/** Nodes in several processes. */
@Tag("realtime")
class RosNodeProcessTest {

  private static final int ROBOTS = 4;
  private static final int OPENINGS = 100;
  private static final long LIMIT_S = 60;

  /** One robot: it joins the network, and ends. */
  static final class Joining {
    public static void main(String[] args) throws IOException {
      RosNode.open("joining", () -> 0, (timeNs, level, tag, line) -> {}).close();
    }
  }

  private static final RosTopic TOPIC =
      new RosTopic("robots.bot0.topics.command", "/starl_test/talk", "Twist", false, false);

  /** Publishes a thousand messages a second, until it is killed. */
  static final class Talking {
    public static void main(String[] args) throws IOException {
      try (RosNode node = RosNode.open("talking", () -> 0, (timeNs, level, tag, line) -> {})) {
        RosNode.Output output = node.publish(TOPIC, false);
        while (!Thread.currentThread().isInterrupted()) {
          output.publish(Messages.twist(WheelCommand.STOP, RosType.TWIST, 0));
          LockSupport.parkNanos(Time.NS_PER_MS);
        }
      }
    }
  }

  @TempDir private Path home;

  private Process process(Class<?> main) throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:ErrorFile=" + home.resolve("error"),
            "-Duser.home=" + home,
            "-cp",
            System.getProperty("java.class.path"),
            main.getName())
        .redirectErrorStream(true)
        .start();
  }

  @Test
  @Timeout(value = LIMIT_S, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void inputsAreOpenedAndClosedWhileMessagesArrive() throws IOException, InterruptedException {
    Process one = process(Talking.class);
    Process another = process(Talking.class);
    try (RosNode other = node()) {
      // The process stays on the network meanwhile.
      other.subscribe(TOPIC, false, message -> {});
      for (int i = 0; i < OPENINGS; i++) {
        CountDownLatch arrived = new CountDownLatch(1);
        try (RosNode node = node()) {
          node.subscribe(TOPIC, false, message -> arrived.countDown());
          arrived.await();
        }
      }
    } finally {
      one.destroyForcibly();
      another.destroyForcibly();
    }
  }

  private static RosNode node() throws IOException {
    return RosNode.open("node", RealClock::machineNs, (timeNs, level, tag, line) -> {});
  }

  /** On a computer that has never run one with ROS 2. */
  @Test
  void robotsStartTogetherTheFirstTime() throws IOException, InterruptedException {
    List<Process> robots = new ArrayList<>();
    for (int i = 0; i < ROBOTS; i++) {
      robots.add(process(Joining.class));
    }
    for (Process robot : robots) {
      String text = new String(robot.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertThat(robot.waitFor()).as(text).isZero();
    }
  }
}

package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.body.WheelCommand;
import org.starl.robot.file.RosTopic;
import org.starl.robot.realtime.RealClock;

/** Two nodes of this library, over DDS. */
@Tag("realtime")
class RosNodeTest {

  private static final long LIMIT_S = 30;

  private final BlockingQueue<Object> received = new LinkedBlockingQueue<>();

  private RosNode node(String name) throws IOException {
    return RosNode.open(
        name, RealClock::machineNs, (timeNs, level, tag, line) -> received.add(name + ": " + line));
  }

  private static RosTopic topic(String name, boolean isReliable) {
    return new RosTopic("robots.bot0.topics.command", name, "Twist", isReliable, false);
  }

  @Test
  void aMessageArrivesByteByByte() throws IOException, InterruptedException {
    RosTopic topic = topic("/starl_test/one", true);
    try (RosNode base = node("base");
        RosNode robot = node("robot")) {
      base.subscribe(topic, false, message -> received.add(message.f64()));
      RosNode.Output output = robot.publish(topic, true);
      Object first = null;
      for (int i = 0; i < 200 && first == null; i++) {
        output.publish(Messages.twist(new WheelCommand(250, 0), RosType.TWIST, 0));
        first = received.poll(50, TimeUnit.MILLISECONDS);
      }
      assertThat(first).isEqualTo(0.25);
      assertThat(output.hasReceiver()).isTrue();
    }
  }

  @Test
  void aWrongQualityOfServiceIsToldWithWhatToSet() throws IOException, InterruptedException {
    try (RosNode base = node("base");
        RosNode robot = node("robot")) {
      base.subscribe(topic("/starl_test/two", true), false, message -> {});
      robot.publish(topic("/starl_test/two", false), true);
      assertThat(received.poll(LIMIT_S, TimeUnit.SECONDS))
          .isEqualTo(
              "robot: /starl_test/two: a node is there, but not with Twist, best_effort, volatile; set"
                  + " robots.bot0.topics.command.reliability: reliable");
    }
  }

  @Test
  void theDomainIsANumber() throws IOException {
    assertThat(RosNode.domainId(null)).isZero();
    assertThat(RosNode.domainId(" 42 ")).isEqualTo(42);
    assertThatThrownBy(() -> RosNode.domainId("233"))
        .hasMessage("ROS_DOMAIN_ID: '233': expected a whole number from 0 to 232");
    assertThatThrownBy(() -> RosNode.domainId("a")).hasMessageStartingWith("ROS_DOMAIN_ID: 'a'");
  }
}

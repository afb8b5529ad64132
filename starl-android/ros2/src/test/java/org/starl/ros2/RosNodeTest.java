package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Phaser;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.RepeatedTest;
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

  @RepeatedTest(10)
  void nodesOpenTopicsOfOneTypeAtOneTime() throws Exception {
    int nodes = 4;
    Phaser together = new Phaser(nodes);
    List<Callable<Void>> openings = new ArrayList<>();
    for (int i = 0; i < nodes; i++) {
      openings.add(() -> {
        try (RosNode node = node("node")) {
          for (RosType type : RosType.values()) {
            together.arriveAndAwaitAdvance();
            node.subscribe(
                new RosTopic("key", "/starl_test/three", type.shortName(), true, false),
                false,
                message -> {});
          }
        } finally {
          together.arriveAndDeregister();
        }
        return null;
      });
    }
    try (ExecutorService threads = Executors.newFixedThreadPool(nodes)) {
      for (Future<Void> opening : threads.invokeAll(openings)) {
        opening.get();
      }
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

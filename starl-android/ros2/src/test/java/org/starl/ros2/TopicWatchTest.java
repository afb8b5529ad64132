package org.starl.ros2;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.robot.file.RosTopic;

/** What is told about a topic, for a node that stands for DDS's rules of matching. */
class TopicWatchTest {

  private static final long MS = 1_000_000;
  private static final long THREE_S = 3000 * MS;

  private final List<String> lines = new ArrayList<>();
  private int open;

  /** Runs until three seconds after the opening. */
  private TopicWatch run(RosTopic ours, boolean isPublisher, Predicate<RosTopic> node) {
    TopicWatch watch =
        new TopicWatch(
            ours,
            isPublisher,
            TopicWatch.types(RosType.of(ours.type())),
            (topic, publishes, matched) -> {
              open++;
              if (node.test(topic)) {
                matched.accept(true);
              }
              return () -> open--;
            },
            (level, line) -> lines.add(line));
    watch.begin(0);
    if (node.test(ours)) {
      watch.matched(true);
    }
    for (long ns = 0; ns <= THREE_S; ns += 100 * MS) {
      watch.advance(ns);
    }
    return watch;
  }

  private static RosTopic topic(String type, boolean isReliable, boolean isTransientLocal) {
    return new RosTopic(
        "robots.bot0.topics.command", "/bot0/cmd_vel", type, isReliable, isTransientLocal);
  }

  /** Whether a subscription is served by an offer: DDS, "requested versus offered". */
  private static boolean isServed(RosTopic offer, RosTopic request) {
    return offer.type().equals(request.type())
        && (offer.isReliable() || !request.isReliable())
        && (offer.isTransientLocal() || !request.isTransientLocal());
  }

  @Property
  void whatIsToldIsWhatMakesTheTwoMatch(
      @ForAll boolean isPublisher,
      @ForAll boolean reliable,
      @ForAll boolean local,
      @ForAll boolean theirsReliable,
      @ForAll boolean theirsLocal) {
    lines.clear();
    RosTopic theirs = topic("Twist", theirsReliable, theirsLocal);
    RosTopic ours = topic("Twist", reliable, local);
    run(ours, isPublisher, end -> isPublisher ? isServed(end, theirs) : isServed(theirs, end));
    assertThat(open).isZero();
    if (isPublisher ? isServed(ours, theirs) : isServed(theirs, ours)) {
      assertThat(lines).isEmpty();
      return;
    }
    assertThat(lines).singleElement().asString().contains("/bot0/cmd_vel: a node is there");
    String line = lines.get(0);
    RosTopic mended =
        topic(
            "Twist",
            line.contains("set") && line.contains("reliability: ")
                ? line.contains("reliability: reliable")
                : reliable,
            line.contains("durability: ") ? line.contains("durability: transient") : local);
    assertThat(isPublisher ? isServed(mended, theirs) : isServed(theirs, mended)).isTrue();
  }

  @Test
  void anotherTypeIsNamed() {
    run(topic("Twist", true, false), true, end -> end.type().equals("TwistStamped"));
    assertThat(lines)
        .containsExactly(
            "/bot0/cmd_vel: a node is there, but not with Twist, reliable, volatile; set"
                + " robots.bot0.topics.command.type: TwistStamped");
  }

  @Test
  void nobodyIsToldOnceAndThatSomebodyHasCome() {
    TopicWatch watch = run(topic("Twist", true, false), true, end -> false);
    assertThat(lines).singleElement().asString().contains("/bot0/cmd_vel: no node subscribes");
    watch.advance(2 * THREE_S);
    watch.matched(true);
    watch.advance(2 * THREE_S + 1);
    assertThat(lines).hasSize(2);
    assertThat(open).isZero();
    watch.matched(false);
    watch.advance(3 * THREE_S);
    assertThat(lines).last().isEqualTo("/bot0/cmd_vel: its node has left");
  }
}

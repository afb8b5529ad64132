package org.starl.ros2;

import static org.starl.time.Time.NS_PER_MS;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.platform.LogSink.Level;
import org.starl.robot.file.RosTopic;

/**
 * Finds out why an end of a topic is matched by no other node. DDS does not tell; so ends with every
 * other quality of service and type are opened for a short time: the one that is matched shows what to
 * set. Pure but for these. From any thread.
 */
final class TopicWatch {

  /** Time for the discovery of other nodes. */
  static final long DISCOVERY_NS = 1000 * NS_PER_MS;

  /** Of two ends that one node matches, one may be told before the other. */
  static final long GRACE_NS = 300 * NS_PER_MS;

  static final long ABSENT_NS = 2500 * NS_PER_MS;

  private static final List<RosType> POSES =
      List.of(RosType.POSE_STAMPED, RosType.POSE_WITH_COVARIANCE_STAMPED, RosType.ODOMETRY);

  /** Opens an end that shows whether it is matched. */
  @FunctionalInterface
  interface Prober {
    AutoCloseable open(RosTopic topic, boolean isPublisher, Consumer<Boolean> matched)
        throws IOException;
  }

  private static final class Probe {
    final RosTopic topic;
    @Nullable AutoCloseable end;
    volatile boolean isMatched;

    Probe(RosTopic topic) {
      this.topic = topic;
    }
  }

  private final RosTopic topic;
  private final boolean isPublisher;
  private final List<RosType> types;
  private final Prober prober;
  private final BiConsumer<Level, String> tell;
  private final List<Probe> probes = new ArrayList<>();
  private final AtomicInteger matches = new AtomicInteger();
  private long sinceNs;
  private long probeMatchedNs = Long.MAX_VALUE;
  private boolean wasMatched;
  private boolean isTold;
  private boolean isAbsenceTold;

  /**
   * @param types the types that a robot's file may name for this topic; none: it is not watched
   */
  TopicWatch(
      RosTopic topic,
      boolean isPublisher,
      List<RosType> types,
      Prober prober,
      BiConsumer<Level, String> tell) {
    this.topic = topic;
    this.isPublisher = isPublisher;
    this.types = types;
    this.prober = prober;
    this.tell = tell;
  }

  /** The types that a file may name instead of this one. */
  static List<RosType> types(RosType type) {
    return Stream.of(
            POSES,
            List.of(RosType.TWIST, RosType.TWIST_STAMPED),
            List.of(RosType.BOOL, RosType.LASER_SCAN, RosType.HAZARD_DETECTION_VECTOR))
        .filter(group -> group.contains(type))
        .findFirst()
        .orElse(List.of(type));
  }

  /** The end is opened. */
  synchronized void begin(long nowNs) {
    sinceNs = nowNs;
  }

  /** Another node's end was matched, or is gone. */
  void matched(boolean isMore) {
    // Without the lock: the library calls this while it opens and closes ends.
    matches.addAndGet(isMore ? 1 : -1);
  }

  boolean isMatched() {
    return matches.get() > 0;
  }

  /** Once in a while. */
  synchronized void advance(long nowNs) {
    if (isMatched()) {
      if (isTold || isAbsenceTold) {
        tell.accept(Level.INFO, topic.name() + ": a node is there now");
      }
      closeProbes();
      wasMatched = true;
      isTold = false;
      isAbsenceTold = false;
      return;
    }
    if (types.isEmpty()) {
      return;
    }
    if (wasMatched) {
      tell.accept(Level.WARN, topic.name() + ": its node has left");
      wasMatched = false;
      sinceNs = nowNs;
    }
    if (isTold || nowNs - sinceNs < DISCOVERY_NS) {
      return;
    }
    if (probes.isEmpty()) {
      openProbes();
    }
    if (probeMatchedNs == Long.MAX_VALUE && probes.stream().anyMatch(probe -> probe.isMatched)) {
      probeMatchedNs = nowNs;
    }
    if (nowNs - probeMatchedNs >= GRACE_NS) {
      probes.stream().filter(probe -> probe.isMatched).findFirst().ifPresent(this::tellMismatch);
    } else if (nowNs - sinceNs >= ABSENT_NS && probeMatchedNs == Long.MAX_VALUE && !isAbsenceTold) {
      isAbsenceTold = true;
      tell.accept(
          Level.WARN,
          topic.name()
              + ": no node "
              + (isPublisher ? "subscribes to" : "publishes")
              + " it; expected one with "
              + RosType.of(topic.type())
              + ": check the base, "
              + topic.key()
              + ".name and ROS_DOMAIN_ID");
    }
  }

  private void tellMismatch(Probe probe) {
    List<String> settings = new ArrayList<>();
    RosTopic other = probe.topic;
    if (!other.type().equals(topic.type())) {
      settings.add(topic.key() + ".type: " + other.type());
    } else {
      if (other.isReliable() != topic.isReliable()) {
        settings.add(topic.key() + ".reliability: " + reliability(other));
      }
      if (other.isTransientLocal() != topic.isTransientLocal()) {
        settings.add(topic.key() + ".durability: " + durability(other));
      }
    }
    tell.accept(
        Level.WARN,
        String.format(
            "%s: a node is there, but not with %s, %s, %s; set %s",
            topic.name(),
            topic.type(),
            reliability(topic),
            durability(topic),
            String.join(" and ", settings)));
    isTold = true;
    closeProbes();
  }

  private static String reliability(RosTopic topic) {
    return topic.isReliable() ? "reliable" : "best_effort";
  }

  private static String durability(RosTopic topic) {
    return topic.isTransientLocal() ? "transient_local" : "volatile";
  }

  /** In the order of their distance from what is set: the first that is matched is told. */
  private void openProbes() {
    boolean reliable = topic.isReliable();
    boolean local = topic.isTransientLocal();
    add(topic.type(), !reliable, local);
    add(topic.type(), reliable, !local);
    add(topic.type(), !reliable, !local);
    for (RosType type : types) {
      if (!type.shortName().equals(topic.type())) {
        // An offer of the strongest is taken by all, and a request of the weakest served by all.
        add(type.shortName(), isPublisher, isPublisher);
      }
    }
  }

  private void add(String type, boolean isReliable, boolean isTransientLocal) {
    Probe probe =
        new Probe(new RosTopic(topic.key(), topic.name(), type, isReliable, isTransientLocal));
    try {
      probe.end = prober.open(probe.topic, isPublisher, isMore -> probe.isMatched = isMore);
      probes.add(probe);
    } catch (IOException e) {
      tell.accept(Level.WARN, topic.name() + ": cannot look for its node: " + e.getMessage());
    }
  }

  private void closeProbes() {
    for (Probe probe : probes) {
      try {
        if (probe.end != null) {
          probe.end.close();
        }
      } catch (Exception e) {
        throw new IllegalStateException(e);
      }
    }
    probes.clear();
    probeMatchedNs = Long.MAX_VALUE;
  }
}
